// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_START_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_START_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The label of a vertex: how far it is, and the halfedge that leads there.
struct Forest_label
{
  double distance = (std::numeric_limits<double>::max)();
  Index previous = no_index;
};

/// the shortest paths from some vertices to all others, along edges that are not to be avoided.
inline Shortest_paths<Forest_label> shortest_forest(const Cut_problem& problem,
                                                    const std::vector<Index>& sources) {
  const Flat_halfedges& halfedges = problem.halfedges;
  Shortest_paths<Forest_label> paths(problem.mesh.number_of_vertices());
  for(const Index v : sources)
    paths.reach(v, {0., no_index});
  paths.grow([&](Index v) {
    for(Index h = halfedges.begin(v); h < halfedges.end(v); ++h) {
      const double sum = paths[v].distance + problem.weight[h];
      if(sum < paths[halfedges.target(h)].distance && !problem.is_avoided(h))
        paths.reach(halfedges.target(h), {sum, h});
    }
  });
  return paths;
}

/// the vertex farthest from another one.
inline Index farthest_from(const Cut_problem& problem, Index v) {
  const Shortest_paths<Forest_label> paths = shortest_forest(problem, {v});
  Index farthest = problem.halfedges.target(problem.halfedges.begin(v));
  for(Index u = 0; u < problem.mesh.number_of_vertices(); ++u)
    if(paths.is_reached(u) && paths[u].distance > paths[farthest].distance)
      farthest = u;
  return farthest;
}

/// gives the arcs of spheres their ends, as cones: where the caller wants one or names one vertex,
/// a sphere is cut from there, or from one end of it, to the vertex farthest away.
inline void add_ends_on_spheres(Cut_problem& problem) {
  const std::vector<Component_size> sizes = component_sizes(problem);
  std::vector<std::vector<Index>> cones(sizes.size());
  for(Index v = 0; v < problem.cones.size(); ++v)
    if(problem.is_cone(v))
      cones[problem.mesh.component[v]].push_back(v);
  std::vector<char> is_kept(sizes.size(), 0);
  for(Index h = 0; h < problem.rules.size(); ++h)
    if(problem.is_kept(h))
      is_kept[problem.mesh.component[problem.halfedges.source(h)]] = 1;
  const auto add_cone = [&](Index v) {
    problem.cones.resize(problem.mesh.number_of_vertices(), 0);
    problem.cones[v] = 1;
  };
  for(std::size_t c = 0; c < sizes.size(); ++c)
    if(sizes[c].genus() == 0 && !is_kept[c]) {
      if(cones[c].size() == 1 && problem.mesh.is_hub(cones[c][0]))
        problem.cones[cones[c][0]] = 0; // a disk as it is
      else if(cones[c].size() == 1)
        add_cone(farthest_from(problem, cones[c][0]));
      else if(cones[c].empty() && problem.do_cut_spheres) {
        const Index end = farthest_from(problem, problem.mesh.seeds[c]);
        add_cone(end);
        add_cone(farthest_from(problem, end));
      }
    }
}

/*!
Finds a cut that uses given walks as far as it can.

Faces are joined across edges as long as they do not hang together yet: the faces become one piece
without a cycle, a disk, and the edges that are left are a cut, once its dead ends are off. Edges
that are to be avoided are joined first, so that they are left only if there is no other cut; those
that are on no walk follow, those far from the walks first; then the edges of the walks, long ones
first. So what is left are the walks, the shortest arcs that connect them, and no more of the walks
than needed. (Kruskal's algorithm on the dual graph; of tree and cotree, see Erickson and
Whittlesey, 2005.)
*/
class Cut_start
{
public:
  explicit Cut_start(const Cut_problem& problem)
      : problem_(problem)
      , in_base_(problem.halfedges.size(), 0) {
    for(const std::vector<Index>& walk : problem.walks)
      for(std::size_t i = 0; i < walk.size(); ++i) {
        const Index h = halfedges().between(walk[i], walk[i + 1 == walk.size() ? 0 : i + 1]);
        if(!problem.is_avoided(h))
          in_base_[h] = in_base_[halfedges().twin(h)] = 1;
      }
    for(Index h = 0; h < problem.rules.size(); ++h)
      if(problem.is_kept(h))
        in_base_[h] = 1;
  }

  /// throws `No_cut_exception` if the rules for edges leave no cut.
  Cut_graph find() const {
    if(is_base_connected()) { // then it does not matter how far the others are
      Cut_graph cut = cut_of(false);
      if(is_in_base(cut))
        return cut;
    }
    return cut_of(true);
  }

private:
  struct Keyed_edge
  {
    double key;
    Index halfedge;
  };

  const Flat_halfedges& halfedges() const { return problem_.halfedges; }

  bool is_base_connected() const {
    const std::size_t n = problem_.mesh.number_of_vertices();
    Sets_of_indices sets(n);
    std::vector<char> is_used(n, 0);
    for(Index h = 0; h < halfedges().size(); ++h)
      if(in_base_[h]) {
        is_used[halfedges().source(h)] = 1;
        sets.unite(halfedges().source(h), halfedges().target(h));
      }
    std::vector<Index> some(problem_.mesh.seeds); // a vertex of the base, by component
    std::vector<char> is_found(some.size(), 0);
    for(Index v = 0; v < n; ++v)
      if(is_used[v] || problem_.is_cone(v)) {
        const Index component = problem_.mesh.component[v];
        if(is_found[component] && sets.find(some[component]) != sets.find(v))
          return false;
        is_found[component] = 1;
        some[component] = v;
      }
    return true;
  }

  bool is_in_base(const Cut_graph& cut) const {
    for(Index h = 0; h < halfedges().size(); ++h)
      if(cut.contains(h) && !in_base_[h])
        return false;
    return true;
  }

  Cut_graph cut_of(bool by_distance) const {
    Sets_of_indices sets(problem_.mesh.number_of_faces());
    std::vector<char> is_crossed(halfedges().size(), 0);
    std::size_t joins = 0;
    for(const Index h : edges_to_join(by_distance)) {
      const Index twin = halfedges().twin(h);
      if(!sets.unite(halfedges().face(h), halfedges().face(twin)))
        continue;
      is_crossed[h] = is_crossed[twin] = 1;
      ++joins;
    }
    if(joins + problem_.mesh.seeds.size() != problem_.mesh.number_of_faces())
      throw No_cut_exception("the edges to keep cut off a part of the surface");
    return pruned(is_crossed);
  }

  // Those across which faces are joined, in this order.
  std::vector<Index> edges_to_join(bool by_distance) const {
    std::vector<Index> order;
    for(Index h = 0; h < problem_.rules.size(); ++h)
      if(problem_.is_avoided(h))
        order.push_back(h);
    if(by_distance)
      append_others_by_distance(order);
    else
      for(Index h = 0; h < halfedges().size(); ++h)
        if(!in_base_[h])
          order.push_back(h);
    std::vector<Keyed_edge> base;
    for(Index h = 0; h < halfedges().size(); ++h)
      if(in_base_[h] && halfedges().source(h) < halfedges().target(h) && !problem_.is_kept(h))
        base.push_back({problem_.weight[h], h});
    append_long_ones_first(base, order);
    return order;
  }

  void append_others_by_distance(std::vector<Index>& order) const {
    const Shortest_paths<Forest_label> forest = shortest_forest(problem_, places_of_base());
    std::vector<Keyed_edge> others, paths;
    for(Index h = 0; h < halfedges().size(); ++h) {
      const Index u = halfedges().source(h), v = halfedges().target(h);
      if(in_base_[h] || u > v || problem_.is_avoided(h))
        continue;
      const bool is_on_path = forest[v].previous == h || forest[u].previous == halfedges().twin(h);
      const double key = forest[u].distance + problem_.weight[h] + forest[v].distance;
      (is_on_path ? paths : others).push_back({key, h});
    }
    append_long_ones_first(others, order);
    append_long_ones_first(paths, order);
  }

  static void append_long_ones_first(std::vector<Keyed_edge>& edges, std::vector<Index>& order) {
    std::sort(edges.begin(), edges.end(), [](const Keyed_edge& a, const Keyed_edge& b) {
      return a.key > b.key || (a.key == b.key && a.halfedge < b.halfedge);
    });
    for(const Keyed_edge& e : edges)
      order.push_back(e.halfedge);
  }

  // Where a component has no base and no cone, its seed.
  std::vector<Index> places_of_base() const {
    std::vector<Index> places;
    std::vector<char> has_place(problem_.mesh.seeds.size(), 0);
    for(Index v = 0; v < problem_.mesh.number_of_vertices(); ++v)
      if(problem_.is_cone(v) || is_in_base(v)) {
        places.push_back(v);
        has_place[problem_.mesh.component[v]] = 1;
      }
    for(const Index v : problem_.mesh.seeds)
      if(!has_place[problem_.mesh.component[v]])
        places.push_back(v);
    return places;
  }

  bool is_in_base(Index v) const {
    for(Index h = halfedges().begin(v); h < halfedges().end(v); ++h)
      if(in_base_[h])
        return true;
    return false;
  }

  Cut_graph pruned(const std::vector<char>& is_crossed) const {
    Cut_graph cut(problem_);
    for(Index h = 0; h < halfedges().size(); ++h)
      if(!is_crossed[h])
        cut.insert(h);
    for(Index v = 0; v < problem_.mesh.number_of_vertices(); ++v)
      cut.prune(v, [](Index) {});
    for(Index h = 0; h < problem_.rules.size(); ++h)
      if(problem_.is_avoided(h) && cut.contains(h))
        throw No_cut_exception("the edges to avoid leave no cut: the cut needs edge " +
                               std::to_string(problem_.mesh.original[halfedges().source(h)]) +
                               " - " +
                               std::to_string(problem_.mesh.original[halfedges().target(h)]));
    return cut;
  }

  const Cut_problem& problem_;
  std::vector<char> in_base_; // by halfedge
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_START_H
