// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_VORONOI_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_VORONOI_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Parallel_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
One field grows from both sides of all loops, none of which it may cross: each vertex belongs to the
side from which it was reached first. Where the regions of two sides meet there is a gate, at the
edge over which the way from loop to loop is shortest.

The regions cover the mesh once, however many loops there are and however long the ways between
them.
*/
class Voronoi_regions
{
public:
  /// `2 j` is what was reached from the left of loop `j`, `2 j + 1` from its right.
  using Region = Index;

  /// An edge from one region to another; or one vertex that lies beside the loops of both.
  struct Gate
  {
    Region from, to;
    float length; ///< of the way from loop to loop
    Index exit, entry;

    bool operator<(const Gate& other) const {
      return std::tie(from, to, length, exit, entry) <
             std::tie(other.from, other.to, other.length, other.exit, other.entry);
    }
  };

  /// \p times are the arrival times of the field.
  Voronoi_regions(Execution execution,
                  const Flat_mesh& mesh,
                  const std::vector<Time>& times,
                  const std::vector<Crossing_loop>& loops,
                  const Crossing_index& index)
      : mesh_(mesh)
      , index_(index)
      , parent_(mesh.number_of_vertices(), no_index)
      , region_(mesh.number_of_vertices(), no_index)
      , distance_(mesh.number_of_vertices(), 0.f)
      , gates_begin_(2 * loops.size() + 1, 0) {
    for(Region r = 0; r < number_of_regions(); ++r)
      for(const Crossing& c : loops[r / 2])
        add_source(r, c.*side_of(r));
    find_parents(execution, times);
    assign_vertices();
    find_gates(execution);
  }

  static Parallel_paths::End side_of(Region r) {
    return r % 2 == 0 ? Parallel_paths::left : Parallel_paths::right;
  }

  std::size_t number_of_regions() const { return gates_begin_.size() - 1; }
  Region region(Index v) const { return region_[v]; }

  /// the gates of region `r` have the numbers from `gates_begin(r)` up to `gates_begin(r + 1)`.
  Index gates_begin(Region r) const { return gates_begin_[r]; }
  const Gate& gate(Index i) const { return gates_[i]; }

  /// the walk from `v` within its region to a vertex beside the loop.
  std::vector<Index> descent(Index v) const {
    std::vector<Index> walk(1, v);
    for(; parent_[v] != no_index; walk.push_back(v))
      v = parent_[v];
    return walk;
  }

private:
  static constexpr Loops_from all_loops = {0};

  // A vertex beside several loops belongs to one of them; the others meet that one there.
  void add_source(Region r, Index v) {
    if(region_[v] == no_index)
      region_[v] = r;
    else if(region_[v] != r) {
      gates_.push_back({region_[v], r, 0.f, v, v});
      gates_.push_back({r, region_[v], 0.f, v, v});
    }
  }

  bool is_wall(Index u, Index v) const { return index_.is_crossed(u, v, all_loops); }

  void find_parents(Execution execution, const std::vector<Time>& times) {
    for_each_index(execution, mesh_.number_of_vertices(), [&](std::size_t i) {
      const Index v = static_cast<Index>(i);
      if(times[v] != never && region_[v] == no_index)
        parent_[v] = steepest_descent(
            mesh_, v, [&](Index u) { return times[u]; }, [&](Index u) { return !is_wall(v, u); });
      CGAL_assertion_msg(parent_[v] != v, "what is no source has an earlier neighbour");
    });
  }

  // Each vertex belongs to where its parent belongs.
  void assign_vertices() {
    std::vector<Index> path;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v) {
      for(Index u = v; region_[u] == no_index && parent_[u] != no_index; u = parent_[u])
        path.push_back(u);
      for(; !path.empty(); path.pop_back()) {
        const Index u = path.back(), p = parent_[u];
        CGAL_assertion(region_[p] != no_index);
        region_[u] = region_[p];
        distance_[u] = distance_[p] + static_cast<float>(mesh_.edge_length(u, p));
      }
    }
  }

  void find_gates(Execution execution) {
    const std::vector<Gate> found = collect<Gate>(
        execution, mesh_.number_of_vertices(), [&](std::size_t begin, std::size_t end) {
          std::vector<Gate> gates;
          for(Index v = static_cast<Index>(begin); v < end; ++v)
            append_gates(v, gates);
          keep_shortest(gates);
          return gates;
        });
    gates_.insert(gates_.end(), found.begin(), found.end());
    keep_shortest(gates_);
    CGAL_expensive_assertion(std::is_sorted(gates_.begin(), gates_.end()));
    for(const Gate& gate : gates_)
      ++gates_begin_[gate.from + 1];
    for(std::size_t r = 0; r < number_of_regions(); ++r)
      gates_begin_[r + 1] += gates_begin_[r];
  }

  void append_gates(Index v, std::vector<Gate>& gates) const {
    if(region_[v] == no_index)
      return;
    for(Index u : mesh_.ring(v))
      if(region_[u] != region_[v] && !is_wall(v, u)) {
        const float across = static_cast<float>(mesh_.edge_length(u, v));
        gates.push_back({region_[v], region_[u], distance_[v] + across + distance_[u], v, u});
      }
  }

  // One gate between any two regions.
  static void keep_shortest(std::vector<Gate>& gates) {
    std::sort(gates.begin(), gates.end());
    const auto joins_the_same = [](const Gate& a, const Gate& b) {
      return a.from == b.from && a.to == b.to;
    };
    gates.erase(std::unique(gates.begin(), gates.end(), joins_the_same), gates.end());
  }

  const Flat_mesh& mesh_;
  const Crossing_index& index_;
  std::vector<Index> parent_;      // by vertex; none beside a loop
  std::vector<Region> region_;     // by vertex
  std::vector<float> distance_;    // by vertex: to the loop, along the parents
  std::vector<Gate> gates_;        // sorted
  std::vector<Index> gates_begin_; // by region
};

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

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_VORONOI_SEARCH_H
