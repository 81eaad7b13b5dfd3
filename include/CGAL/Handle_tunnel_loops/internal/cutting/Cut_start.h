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
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Shortest paths from some vertices to all others, along edges that are not to be avoided.
class Shortest_forest
{
public:
  static constexpr double never = (std::numeric_limits<double>::max)();

  explicit Shortest_forest(const Cut_problem& problem)
      : problem_(problem)
      , paths_(problem.mesh.number_of_vertices()) {}

  void add_source(Index v) { paths_.reach(v, {0., no_index}); }

  void grow() {
    const Flat_halfedges& halfedges = problem_.halfedges;
    paths_.grow([&](Index v) {
      for(Index h = halfedges.begin(v); h < halfedges.end(v); ++h) {
        const double sum = distance(v) + problem_.weight[h];
        if(sum < distance(halfedges.target(h)) && !problem_.is_avoided(h))
          paths_.reach(halfedges.target(h), {sum, h});
      }
    });
  }

  /// from the nearest source; `never` where no path leads.
  double distance(Index v) const { return paths_[v].distance; }

  /// whether a halfedge or its twin is on the path to one of its ends.
  bool is_on_path(Index h) const {
    return paths_[problem_.halfedges.target(h)].previous == h ||
           paths_[problem_.halfedges.source(h)].previous == problem_.halfedges.twin(h);
  }

private:
  struct Label
  {
    double distance = never;
    Index previous = no_index; // the halfedge that leads to the vertex
  };

  const Cut_problem& problem_;
  Shortest_paths<Label> paths_; // by vertex
};

/// Gives the arcs of spheres their ends, as cones: where the caller wants one or names one vertex,
/// a sphere is cut from there, or from one end of it, to the vertex farthest away.
class Sphere_ends
{
public:
  explicit Sphere_ends(Cut_problem& problem)
      : problem_(problem) {}

  void add() {
    const std::vector<Component_size> sizes = component_sizes(problem_);
    std::vector<Index> number_of_cones(sizes.size(), 0), some_cone(sizes.size(), no_index);
    for(Index v = 0; v < problem_.cones.size(); ++v)
      if(problem_.is_cone(v)) {
        ++number_of_cones[problem_.mesh.component[v]];
        some_cone[problem_.mesh.component[v]] = v;
      }
    std::vector<char> is_kept(sizes.size(), 0);
    for(Index h = 0; h < problem_.rules.size(); ++h)
      if(problem_.is_kept(h))
        is_kept[problem_.mesh.component[problem_.halfedges.source(h)]] = 1;
    for(std::size_t c = 0; c < sizes.size(); ++c)
      if(sizes[c].genus() == 0 && !is_kept[c]) {
        if(number_of_cones[c] == 1 && problem_.mesh.is_hub(some_cone[c]))
          problem_.cones[some_cone[c]] = 0; // a disk as it is
        else if(number_of_cones[c] == 1)
          add_cone(farthest_from(some_cone[c]));
        else if(number_of_cones[c] == 0 && problem_.do_cut_spheres) {
          const Index end = farthest_from(problem_.mesh.seeds[c]);
          add_cone(end);
          add_cone(farthest_from(end));
        }
      }
  }

private:
  void add_cone(Index v) {
    problem_.cones.resize(problem_.mesh.number_of_vertices(), 0);
    problem_.cones[v] = 1;
  }

  Index farthest_from(Index v) const {
    Shortest_forest forest(problem_);
    forest.add_source(v);
    forest.grow();
    Index farthest = problem_.halfedges.target(problem_.halfedges.begin(v));
    for(Index u = 0; u < problem_.mesh.number_of_vertices(); ++u)
      if(forest.distance(u) != Shortest_forest::never &&
         forest.distance(u) > forest.distance(farthest))
        farthest = u;
    return farthest;
  }

  Cut_problem& problem_;
};

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
      for(std::size_t i = 0; i < walk.size(); ++i)
        add_to_base(problem.halfedges.between(walk[i], walk[i + 1 == walk.size() ? 0 : i + 1]));
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

  void add_to_base(Index h) {
    if(!problem_.is_avoided(h))
      in_base_[h] = in_base_[halfedges().twin(h)] = 1;
  }

  bool is_base_connected() const {
    const std::size_t n = problem_.mesh.number_of_vertices();
    Sets_of_indices sets(n);
    for(Index v = 0; v < n; ++v)
      sets.make_set(v);
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
    for(Index f = 0; f < problem_.mesh.number_of_faces(); ++f)
      sets.make_set(f);
    std::vector<char> is_crossed(halfedges().size(), 0);
    std::size_t joins = 0;
    const auto join = [&](Index h) {
      const Index twin = halfedges().twin(h), f = sets.find(halfedges().face(h)),
                  g = sets.find(halfedges().face(twin));
      if(f == g)
        return;
      sets.unite(f, g);
      is_crossed[h] = is_crossed[twin] = 1;
      ++joins;
    };
    join_avoided(join);
    join_others(join, by_distance);
    join_base(join);
    if(joins + problem_.mesh.seeds.size() != problem_.mesh.number_of_faces())
      throw No_cut_exception("the edges to keep cut off a part of the surface");
    return pruned(is_crossed);
  }

  template <typename Join> void join_avoided(const Join& join) const {
    for(Index h = 0; h < problem_.rules.size(); ++h)
      if(problem_.is_avoided(h))
        join(h);
  }

  template <typename Join> void join_others(const Join& join, bool by_distance) const {
    if(!by_distance) {
      for(Index h = 0; h < halfedges().size(); ++h)
        if(!in_base_[h])
          join(h);
      return;
    }
    const Shortest_forest forest = forest_around_base();
    std::vector<Keyed_edge> others, paths;
    for(Index h = 0; h < halfedges().size(); ++h)
      if(!in_base_[h] && halfedges().source(h) < halfedges().target(h) && !problem_.is_avoided(h)) {
        const double key = forest.distance(halfedges().source(h)) + problem_.weight[h] +
                           forest.distance(halfedges().target(h));
        (forest.is_on_path(h) ? paths : others).push_back({key, h});
      }
    join_long_ones_first(join, others);
    join_long_ones_first(join, paths);
  }

  template <typename Join> void join_base(const Join& join) const {
    std::vector<Keyed_edge> base;
    for(Index h = 0; h < halfedges().size(); ++h)
      if(in_base_[h] && halfedges().source(h) < halfedges().target(h) && !problem_.is_kept(h))
        base.push_back({problem_.weight[h], h});
    join_long_ones_first(join, base);
  }

  template <typename Join>
  static void join_long_ones_first(const Join& join, std::vector<Keyed_edge>& edges) {
    std::sort(edges.begin(), edges.end(), [](const Keyed_edge& a, const Keyed_edge& b) {
      return a.key > b.key || (a.key == b.key && a.halfedge < b.halfedge);
    });
    for(const Keyed_edge& e : edges)
      join(e.halfedge);
  }

  // Where a component has no base and no cone, paths begin at its seed.
  Shortest_forest forest_around_base() const {
    Shortest_forest forest(problem_);
    std::vector<char> has_source(problem_.mesh.seeds.size(), 0);
    const auto add_source = [&](Index v) {
      has_source[problem_.mesh.component[v]] = 1;
      forest.add_source(v);
    };
    for(Index v = 0; v < problem_.mesh.number_of_vertices(); ++v)
      if(problem_.is_cone(v) || is_in_base(v))
        add_source(v);
    for(const Index v : problem_.mesh.seeds)
      if(!has_source[problem_.mesh.component[v]])
        add_source(v);
    forest.grow();
    return forest;
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
        throw No_cut_exception("the edges to avoid leave no cut: one of them is needed, edge " +
                               std::to_string(problem_.mesh.original[halfedges().source(h)]) +
                               " - " +
                               std::to_string(problem_.mesh.original[halfedges().target(h)]));
    return cut;
  }

  const Cut_problem& problem_;
  std::vector<char> in_base_; // by halfedge
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_START_H
