// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAIST_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAIST_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Minimum_cut.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
      , distance_(mesh.number_of_vertices())
      , previous_(mesh.number_of_vertices())
      , node_(mesh.number_of_vertices()) {
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
    number_nodes(hub);
    if(node_[way.front()] == node_[way.back()])
      return {};
    Minimum_cut cut;
    for_each_edge_of_region([&](Index u, Index v) {
      if(node_[u] != node_[v])
        cut.add_edge(node_[u], node_[v], length_across(u, v));
    });
    is_beside_curve_ = cut.source_side(number_of_nodes_);
    return loop_of_cut();
  }

private:
  using Entry = std::pair<double, Index>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;
  static constexpr double never = (std::numeric_limits<double>::max)();

  bool is_near(Index v) const { return distance_[v] < never; }

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

  void clear_distances() { std::fill(distance_.begin(), distance_.end(), never); }

  void reach(Index v, double distance, Index previous, Queue& queue) {
    distance_[v] = distance;
    previous_[v] = previous;
    queue.push({distance, v});
  }

  // Up to a distance, or to the first vertex that is an end. Returns that, if there is one.
  template <typename Predicate> Index grow(Queue& queue, double radius, const Predicate& is_end) {
    while(!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if(d > distance_[v])
        continue;
      if(is_end(v))
        return v;
      const Index from = v;
      const double done = d;
      for_each_surface_edge(from, [&](Index u) {
        const double sum = done + mesh_.edge_length(from, u);
        if(sum < distance_[u] && sum <= radius)
          reach(u, sum, from, queue);
      });
    }
    return no_index;
  }

  // From the curve around a hub to the nearest other one.
  std::vector<Index> way_to_another(Index hub) {
    clear_distances();
    Queue queue;
    for(const Index v : mesh_.ring(hub))
      reach(v, 0., no_index, queue);
    const auto is_at_another = [&](Index v) {
      return hub_beside_[v] != no_index && hub_beside_[v] != hub;
    };
    std::vector<Index> way;
    for(Index v = grow(queue, never, is_at_another); v != no_index; v = previous_[v])
      way.push_back(v);
    return way;
  }

  void find_region(const std::vector<Index>& way, double longest) {
    // One half, and what ways along edges are longer than straight ones.
    constexpr double share_of_length = 0.6;
    clear_distances();
    Queue queue;
    for(const Index v : way)
      reach(v, 0., no_index, queue);
    grow(queue, share_of_length * longest, [](Index) { return false; });
    region_.clear();
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(is_near(v))
        region_.push_back(v);
  }

  // ---- the graph that is cut

  // The vertices of all boundary curves are two nodes, each other one of the region is a node, and
  // so is each connected part of what is outside.
  void number_nodes(Index hub) {
    std::fill(node_.begin(), node_.end(), no_index);
    number_of_nodes_ = 2;
    for(const Index v : region_) {
      node_[v] = node_at_boundary(v, hub);
      if(node_[v] == no_index)
        node_[v] = number_of_nodes_++;
    }
    for(const Index u : region_)
      for_each_surface_edge(u, [&](Index v) {
        if(node_[v] == no_index)
          number_part_outside(v, hub);
      });
  }

  Index node_at_boundary(Index v, Index hub) const {
    return hub_beside_[v] == no_index ? no_index
           : hub_beside_[v] == hub    ? Minimum_cut::source
                                      : Minimum_cut::sink;
  }

  // It is one with the boundary curves that it comes to. Where these are on both sides no loop in
  // the region parts them, and either side will do.
  void number_part_outside(Index first, Index hub) {
    const Index number = number_of_nodes_;
    Index node = number;
    std::vector<Index> part = {first};
    node_[first] = number;
    for(std::size_t i = 0; i < part.size(); ++i) {
      node = (std::min)(node, node_at_boundary(part[i], hub));
      for_each_surface_edge(part[i], [&](Index v) {
        if(node_[v] == no_index) {
          node_[v] = number;
          part.push_back(v);
        }
      });
    }
    for(const Index v : part)
      node_[v] = node;
    number_of_nodes_ += node == number;
  }

  // From the middle of one face at an edge to that of the other: three times that.
  double length_across(Index u, Index v) const {
    const Ring ring = mesh_.ring(u);
    const Index p = ring.position(v);
    return norm(mesh_.points[ring[ring.next(p)]] - mesh_.points[ring[ring.previous(p)]]);
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
  std::vector<double> distance_;  // by vertex
  std::vector<Index> previous_;   // by vertex, on the way to it
  std::vector<Index> region_;     // vertices
  std::vector<Index> node_;       // by vertex
  Index number_of_nodes_ = 0;
  std::vector<char> is_beside_curve_; // by node
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAIST_SEARCH_H
