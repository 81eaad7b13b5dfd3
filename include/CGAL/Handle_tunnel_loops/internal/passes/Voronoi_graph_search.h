// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_VORONOI_GRAPH_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_VORONOI_GRAPH_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/passes/Voronoi_regions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <CGAL/assertions.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Finds the way from one side of a loop around to the other as the shortest path in the graph of the
regions, in which gates are edges, and so are the loops that may be crossed. The path becomes a walk
on the edges of the mesh: up to a gate, down from it to the next loop, along that loop, and so on.
Its length is that of the ways through the gates; what is gone along the loops is left out.

A workspace that can be used again and again; a search costs as much as the part of the graph
that is nearer than its goal.
*/
class Voronoi_graph_search
{
public:
  Voronoi_graph_search(const Flat_mesh& mesh,
                       const std::vector<Crossing_loop>& loops,
                       const Crossing_index& index,
                       const Voronoi_regions& regions)
      : mesh_(mesh)
      , loops_(loops)
      , index_(index)
      , regions_(regions)
      , paths_(regions.number_of_regions()) {}

  /// returns a closed walk that crosses loop `k` once, and no loop after it. Empty if there is
  /// none: where loops run close beside each other, the way along one may cross another.
  std::vector<Index> dual_walk(Index k) {
    std::vector<Index> walk;
    if(find_path(k)) {
      walk = walk_of_path(k);
      const Loops_from barred = {k};
      if(!is_dual(index_.intersections(walk), k, barred))
        walk.clear();
    }
    paths_.clear();
    return walk;
  }

private:
  using Region = Voronoi_regions::Region;
  using Gate = Voronoi_regions::Gate;
  using Step = Index; // the number of a gate, or:
  static constexpr Step across = no_index;

  struct Label
  {
    float distance = std::numeric_limits<float>::infinity();
    Step last_step = across;
  };

  static Region left_of(Index loop) { return 2 * loop; }
  static Region right_of(Index loop) { return 2 * loop + 1; }
  static Region other_side(Region r) { return r ^ 1; }

  bool find_path(Index k) {
    bool is_found = false;
    relax(right_of(k), 0.f, across);
    paths_.grow([&](float) { return !is_found; },
                [&](Region r) {
                  is_found = r == left_of(k);
                  if(!is_found)
                    leave(r, k);
                });
    return is_found;
  }

  void leave(Region r, Index k) {
    const float length = paths_[r].distance;
    for(Index i = regions_.gates_begin(r); i < regions_.gates_begin(r + 1); ++i)
      relax(regions_.gate(i).to, length + regions_.gate(i).length, i);
    if(r < left_of(k))
      relax(other_side(r), length, across);
  }

  void relax(Region r, float length, Step step) {
    if(length < paths_[r].distance)
      paths_.reach(r, {length, step});
  }

  std::vector<Step> path(Index k) const {
    std::vector<Step> steps;
    for(Region r = left_of(k); r != right_of(k);) {
      const Step step = paths_[r].last_step;
      CGAL_assertion_msg(paths_.is_reached(r), "the path leads through regions that were reached");
      CGAL_assertion(step == across || regions_.gate(step).to == r);
      steps.push_back(step);
      r = step == across ? other_side(r) : regions_.gate(step).from;
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  std::vector<Index> walk_of_path(Index k) {
    std::vector<Index> walk;
    Region region = right_of(k);
    Foot start, foot;
    for(Step step : path(k))
      if(step == across)
        region = other_side(region);
      else {
        const Gate& gate = regions_.gate(step);
        const std::vector<Index> up = way_to_loop(region, gate.exit);
        const Foot next = {Voronoi_regions::side_of(region), up.back()};
        if(walk.empty())
          start = next;
        else
          append_along(region, foot, next, walk);
        walk.insert(walk.end(), up.rbegin(), up.rend());
        region = gate.to;
        const std::vector<Index> down = way_to_loop(region, gate.entry);
        walk.insert(walk.end(), down.begin(), down.end());
        foot = {Voronoi_regions::side_of(region), down.back()};
      }
    CGAL_assertion_msg(!walk.empty(), "a path leads through a gate");
    append_along(region, foot, start, walk);
    remove_spurs(walk);
    return walk;
  }

  // A gate of one vertex leads to a region to which the vertex, beside its loop, does not belong.
  std::vector<Index> way_to_loop(Region r, Index v) const {
    return regions_.region(v) == r ? regions_.descent(v) : std::vector<Index>(1, v);
  }

  // Where a way comes down to a loop: a vertex, on one side of it.
  struct Foot
  {
    Parallel_paths::End side = Parallel_paths::left;
    Index vertex = no_index;
  };

  void append_along(Region r, const Foot& from, const Foot& to, std::vector<Index>& walk) {
    parallel_paths_.measure(mesh_, loops_[r / 2]);
    parallel_paths_.append(Voronoi_regions::side_of(r), from.side, from.vertex, to.side, to.vertex,
                           walk);
  }

  const Flat_mesh& mesh_;
  const std::vector<Crossing_loop>& loops_;
  const Crossing_index& index_;
  const Voronoi_regions& regions_;
  Shortest_paths<Label> paths_; // by region
  Parallel_paths parallel_paths_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_VORONOI_GRAPH_SEARCH_H
