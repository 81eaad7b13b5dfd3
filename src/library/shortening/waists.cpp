// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/shortening/waists.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/length_across.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Class_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Walks_of_class.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Minimum_cut.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The shortest loop that is homologous to a boundary curve, wherever on the surface it is.

A chain of curves is homologous to a boundary curve if and only if it bounds a part of the surface
together with it: a part that holds this curve, and no other one. So the shortest is a minimum cut
between the curve and all others, of the graph of the vertices; an edge weighs as much as the way
across it, from the middle of one face to that of the other. A cut may be of several loops, which
are no loop together; then none is found.

A loop that separates the curve from the nearest other one crosses the way between them, and if it
is short all of it is near that way. What is farther away is cut nowhere.
*/
class Waist_search
{
public:
  explicit Waist_search(const Flat_mesh& mesh)
      : mesh_(mesh)
      , hub_beside_(mesh.number_of_vertices(), no_index)
      , paths_(mesh.number_of_vertices())
      , node_(mesh.number_of_vertices(), no_index) {
    for(Index hub = mesh.first_hub; hub < mesh.first_hub + mesh.number_of_hubs; ++hub)
      for(Index v : mesh.ring(hub))
        hub_beside_[v] = hub;
  }

  /// looks at loops that are not longer. The loop found enters no cap; it is empty if there is no
  /// other boundary curve, or if the shortest are several loops. Mostly near linear in the size of
  /// the mesh.
  Crossing_loop operator()(Index hub, double longest) {
    const std::vector<Index> way = way_to_another(hub);
    if(way.empty())
      return {};
    find_region(way, longest);
    if(!number_nodes(hub))
      return {};
    Minimum_cut cut;
    for_each_edge_of_region([&](Index u, Index v) {
      if(node_[u] != node_[v])
        cut.add_edge(node_[u], node_[v], length_across(mesh_, u, v));
    });
    is_beside_curve_ = cut.source_side(number_of_nodes_);
    return loop_of_cut();
  }

  /// the vertices of a shortest way from the curve around a hub to the nearest other one; empty if
  /// there is none.
  std::vector<Index> way_to_another(Index hub) {
    const auto is_at_another = [&](Index v) {
      return hub_beside_[v] != no_index && hub_beside_[v] != hub;
    };
    std::vector<Index> way;
    for(Index v = grow(mesh_.ring(hub), never, is_at_another); v != no_index;
        v = paths_[v].previous)
      way.push_back(v);
    return way;
  }

private:
  static constexpr double never = (std::numeric_limits<double>::max)();

  struct Label
  {
    double distance = never;
    Index previous = no_index; // on the way to the vertex
  };

  bool is_near(Index v) const { return paths_.is_reached(v); }

  template <typename Function> void for_each_surface_edge(Index u, const Function& f) const {
    for(const Index v : mesh_.ring(u))
      if(!mesh_.is_hub(v))
        f(v);
  }

  // Those that lead out of the region as well.
  template <typename Function> void for_each_edge_of_region(const Function& f) const {
    for(const Index u : region_)
      for_each_surface_edge(u, [&](Index v) {
        if(u < v || !is_near(v))
          f(u, v);
      });
  }

  // ---- distances along edges

  // From some vertices up to a distance, or to the first vertex that is an end. Returns that, if
  // there is one.
  template <typename Vertices, typename Predicate>
  Index grow(const Vertices& from, double radius, const Predicate& is_end) {
    paths_.clear();
    for(const Index v : from)
      paths_.reach(v, {0.});
    Index end = no_index;
    paths_.grow([&](double) { return end == no_index; },
                [&](Index v) {
                  if(is_end(v))
                    end = v;
                  else
                    relax_edges(v, radius);
                });
    return end;
  }

  void relax_edges(Index v, double radius) {
    for_each_surface_edge(v, [&](Index u) {
      const double sum = paths_[v].distance + mesh_.edge_length(v, u);
      if(sum < paths_[u].distance && sum <= radius)
        paths_.reach(u, {sum, v});
    });
  }

  void find_region(const std::vector<Index>& way, double longest) {
    // One half, and what ways along edges are longer than straight ones.
    constexpr double share_of_length = 0.6;
    grow(way, share_of_length * longest, [](Index) { return false; });
    region_ = paths_.reached();
    std::sort(region_.begin(), region_.end()); // neighbours are near in memory
  }

  // ---- the graph that is cut

  // The vertices of all boundary curves are two nodes, each other one of the region is a node, and
  // so is each connected part of what is outside. Returns false if no loop in the region parts the
  // curves.
  bool number_nodes(Index hub) {
    for(const Index v : numbered_)
      node_[v] = no_index;
    numbered_.clear();
    number_of_nodes_ = 2;
    for(const Index v : region_) {
      const Index at_boundary = node_at_boundary(v, hub);
      set_node(v, at_boundary == no_index ? number_of_nodes_++ : at_boundary);
    }
    const Ring curve = mesh_.ring(hub);
    const bool is_curve_near =
        std::all_of(curve.begin(), curve.end(), [this](Index v) { return is_near(v); });
    bool are_parted = true;
    for(const Index u : region_)
      for_each_surface_edge(u, [&](Index v) {
        if(node_[v] == no_index)
          are_parted = number_part_outside(v, hub, is_curve_near) && are_parted;
      });
    return are_parted;
  }

  void set_node(Index v, Index node) {
    node_[v] = node;
    numbered_.push_back(v);
  }

  Index node_at_boundary(Index v, Index hub) const {
    return hub_beside_[v] == no_index ? no_index
           : hub_beside_[v] == hub    ? Minimum_cut::source
                                      : Minimum_cut::sink;
  }

  // It is one with the boundary curves that it comes to, which must not be on both sides. Where
  // only those on one side can be, it is looked at up to the first one.
  bool number_part_outside(Index first, Index hub, bool is_curve_near) {
    const std::size_t begin = numbered_.size();
    const Index number = number_of_nodes_;
    bool is_at[2] = {false, false};
    set_node(first, number);
    for(std::size_t i = begin; i < numbered_.size() && !(is_curve_near && is_at[Minimum_cut::sink]);
        ++i)
    {
      const Index at_boundary = node_at_boundary(numbered_[i], hub);
      if(at_boundary != no_index)
        is_at[at_boundary] = true;
      for_each_surface_edge(numbered_[i], [&](Index v) {
        if(node_[v] == no_index)
          set_node(v, number);
        else if(!is_near(v) && node_[v] == Minimum_cut::sink) // looked at before
          is_at[Minimum_cut::sink] = true;
      });
    }
    const Index node = is_at[Minimum_cut::sink]     ? Minimum_cut::sink
                       : is_at[Minimum_cut::source] ? Minimum_cut::source
                                                    : number_of_nodes_++;
    for(std::size_t i = begin; i < numbered_.size(); ++i)
      node_[numbered_[i]] = node;
    return !is_at[Minimum_cut::sink] || !is_at[Minimum_cut::source];
  }

  // ---- the loop

  bool is_beside_curve(Index v) const { return is_beside_curve_[node_[v]] != 0; }

  // Along the edges that are cut, with the curve to the right; empty if this misses any.
  Crossing_loop loop_of_cut() const {
    Crossing_loop loop;
    std::size_t number = 0;
    for_each_edge_of_region([&](Index u, Index v) {
      if(is_beside_curve(u) != is_beside_curve(v) && ++number == 1)
        loop.push_back(is_beside_curve(u) ? Crossing{v, u, 0.5} : Crossing{u, v, 0.5});
    });
    while(!loop.empty() && loop.size() <= number) {
      const Crossing& c = loop.back();
      const Index apex = apex_ahead(mesh_, c);
      CGAL_assertion(!mesh_.is_hub(apex));
      const Crossing next =
          is_beside_curve(apex) ? Crossing{c.left, apex, 0.5} : Crossing{apex, c.right, 0.5};
      if(next.left == loop.front().left && next.right == loop.front().right)
        break;
      loop.push_back(next);
    }
    return loop.size() == number ? loop : Crossing_loop();
  }

  const Flat_mesh& mesh_;
  std::vector<Index> hub_beside_; // of vertices on boundary curves
  Shortest_paths<Label> paths_;   // by vertex
  std::vector<Index> region_;     // vertices that are reached
  std::vector<Index> node_;       // by vertex
  std::vector<Index> numbered_;   // vertices that have a node
  Index number_of_nodes_ = 0;
  std::vector<char> is_beside_curve_; // by node
};

Crossing_loop boundary_curve(const Flat_mesh& mesh, Index hub) {
  const Ring ring = mesh.ring(hub);
  Crossing_loop loop;
  for(Index p = ring.size(); p-- > 0;)
    loop.push_back({ring[p], hub, 0.});
  return loop;
}

std::vector<Index> boundary_walk(const Flat_mesh& mesh, Index hub) {
  const Ring ring = mesh.ring(hub);
  std::vector<Index> walk(ring.begin(), ring.end());
  std::reverse(walk.begin(), walk.end());
  return walk;
}

Crossing_loop beside_boundary(const Flat_mesh& mesh, Index hub) {
  return pushed_on_surface(mesh, boundary_walk(mesh, hub));
}

std::vector<Index> hubs_of_basis(const Flat_mesh& mesh) {
  std::vector<Index> last(mesh.seeds.size(), no_index), hubs;
  const Index end = mesh.first_hub + mesh.number_of_hubs;
  for(Index hub = mesh.first_hub; hub < end; ++hub)
    last[mesh.component[hub]] = hub;
  for(Index hub = mesh.first_hub; hub < end; ++hub)
    if(last[mesh.component[hub]] != hub)
      hubs.push_back(hub);
  return hubs;
}

/// The searches for waists, with their memory.
struct Waist_searches
{
  Waist_searches(const Flat_mesh& mesh, const Class_numbers& numbers)
      : cut(mesh)
      , walks(mesh, numbers) {}

  Waist_search cut;
  Walks_of_class walks;
};

/// a short loop that is homologous to the curve around a hub on the surface, without any cap: the
/// curve tightened, or what a minimum cut finds, tightened; or the curve itself where that is a
/// point. If a closed walk along edges that is homologous to the curve is shorter, the shortest one
/// is tightened. It crosses every way to another curve, and so has a vertex on any along edges.
static Crossing_loop waist(const Flat_mesh& mesh, Index hub, Waist_searches& search) {
  Crossing_loop best = boundary_curve(mesh, hub), tightened = beside_boundary(mesh, hub);
  Loop_tightening tightening(mesh);
  const auto take_if_shorter = [&](Crossing_loop& loop) {
    tightening.tighten(loop);
    if(!loop.empty() && is_shorter(mesh, loop, best))
      best = std::move(loop);
  };
  take_if_shorter(tightened);
  Crossing_loop found = search.cut(hub, length(mesh, best));
  take_if_shorter(found);
  // Not into a cap: tightening would lead the loop around it on either side, into another class.
  Crossing_loop walk = pushed_on_surface(mesh, search.walks.shortest(boundary_walk(mesh, hub),
                                                                     search.cut.way_to_another(hub),
                                                                     length(mesh, best)));
  take_if_shorter(walk);
  return best;
}

/// the same the other way around.
static Crossing_loop reversed(const Crossing_loop& loop) {
  Crossing_loop result;
  for(std::size_t i = loop.size(); i-- > 0;)
    result.push_back({loop[i].right, loop[i].left, 1. - loop[i].ratio});
  return result;
}

/// by component, which of the boundary curves are its own.
static std::vector<std::vector<Index>> curves_of_components(const Flat_mesh& mesh) {
  std::vector<std::vector<Index>> curves(mesh.seeds.size());
  for(Index i = 0; i < mesh.number_of_hubs; ++i)
    curves[mesh.component[mesh.first_hub + i]].push_back(i);
  return curves;
}

/// where a component has two boundary curves, these are homologous but for the sense: of both
/// waists the shorter one serves.
static void share_waists(const std::vector<std::vector<Index>>& curves,
                         const Flat_mesh& mesh,
                         std::vector<Crossing_loop>& waists) {
  for(const std::vector<Index>& both : curves)
    if(both.size() == 2) {
      Crossing_loop &a = waists[both[0]], &b = waists[both[1]];
      if(is_shorter(mesh, b, a))
        a = reversed(b);
      else
        b = reversed(a);
    }
}

std::vector<Crossing_loop> waists(Execution execution, const Flat_mesh& mesh) {
  std::vector<Crossing_loop> loops(mesh.number_of_hubs);
  const std::vector<std::vector<Index>> curves = curves_of_components(mesh);
  if(std::none_of(curves.begin(), curves.end(), [](const auto& c) { return c.size() > 1; }))
    return loops;
  const Class_numbers numbers(execution, mesh);
  Workspace_pool<Waist_searches> searches(
      [&] { return std::make_unique<Waist_searches>(mesh, numbers); });
  for_each_index(
      execution, loops.size(),
      [&](std::size_t i) {
        const Index hub = mesh.first_hub + static_cast<Index>(i);
        if(curves[mesh.component[hub]].size() > 1)
          loops[i] = waist(mesh, hub, *searches.borrow());
      },
      1);
  share_waists(curves, mesh, loops);
  return loops;
}

} // namespace CGAL::Handle_tunnel_loops::internal
