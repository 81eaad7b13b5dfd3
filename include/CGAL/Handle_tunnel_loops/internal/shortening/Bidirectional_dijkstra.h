// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BIDIRECTIONAL_DIJKSTRA_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BIDIRECTIONAL_DIJKSTRA_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Parallel_paths.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Finds the way from the left side of a loop around to its right side as `Bidirectional_front` does,
but by the lengths of the edges and with the way along the loop that closes it: of the closed walks
that leave the loop on one side, come back on the other, each by a shortest path, and go on along
the loop to where they began, a shortest one. Dijkstra's algorithm runs from both sides at once, up
to half the length that is asked for.

A workspace that can be used again and again; a search costs as much as the region that it covers.
*/
class Bidirectional_dijkstra
{
public:
  explicit Bidirectional_dijkstra(const Flat_mesh& mesh)
      : mesh_(mesh)
      , labels_(mesh.number_of_vertices()) {}

  /// returns a closed walk on the edges that crosses `loop`, number `k` in the index, once. Empty
  /// if there is none shorter than `limit`, or if one has not been found with `number_of_visits`
  /// vertices.
  std::vector<Index> dual_walk(const Crossing_loop& loop,
                               Index k,
                               const Crossing_index& index,
                               double limit,
                               std::size_t number_of_visits) {
    CGAL_precondition(!loop.empty());
    const Only_loop only = {k};
    const Loop_walls<Only_loop> walls(index, only);
    parallel_paths_.measure(mesh_, loop);
    start(loop);
    best_ = {limit, no_index, no_index};
    const bool is_done = search(walls, number_of_visits);
    std::vector<Index> walk;
    if(is_done && best_.left != no_index)
      walk = parallel_paths_.closed_walk(path_back(best_.right), path_back(best_.left));
    if(!is_dual(index.intersections(walk), k, only))
      walk.clear();
    reset();
    return walk;
  }

private:
  static constexpr float infinite = std::numeric_limits<float>::infinity();
  static constexpr std::uint8_t right = 1, visited = 2, beside_loop = 4;

  // How a vertex is reached. Kept together, for they are read together.
  struct Label
  {
    float distance = infinite;
    Index parent = no_index;
    Index source = no_index; // the crossing of the loop from which it is reached
    std::uint8_t state = 0;
  };

  using Entry = std::pair<float, Index>;

  // A priority queue that keeps its memory.
  struct Queue : std::priority_queue<Entry, std::vector<Entry>, std::greater<>>
  {
    void clear() { c.clear(); }
  };

  // Where what is reached from the left meets what is reached from the right.
  struct Meeting
  {
    double length;
    Index left, right;
  };

  void start(const Crossing_loop& loop) {
    for(const std::uint8_t side : {std::uint8_t(0), right})
      for(Index i = 0; i < loop.size(); ++i) {
        const Index v = side == right ? loop[i].right : loop[i].left;
        if(labels_[v].distance == infinite)
          reach(v, {0.f, no_index, i, static_cast<std::uint8_t>(beside_loop | side)});
      }
  }

  void reach(Index v, const Label& label) {
    if(labels_[v].distance == infinite)
      reached_.push_back(v);
    labels_[v] = label;
    queue_.push({label.distance, v});
  }

  // Returns whether it came to an end.
  template <typename Walls> bool search(const Walls& walls, std::size_t number_of_visits) {
    while(!queue_.empty()) {
      const auto [distance, v] = queue_.top();
      queue_.pop();
      if(distance > labels_[v].distance || (labels_[v].state & visited) != 0)
        continue;
      if(2. * distance >= best_.length)
        return true;
      if(number_of_visits-- == 0)
        return false;
      visit(v, walls);
    }
    return true;
  }

  template <typename Walls> void visit(Index v, const Walls& walls) {
    labels_[v].state |= visited;
    const Label here = labels_[v];
    for(Index u : mesh_.ring(v)) {
      const Label& there = labels_[u];
      if((here.state & there.state & beside_loop) != 0 && walls.is_wall(v, u))
        continue;
      const float distance = here.distance + static_cast<float>(mesh_.edge_length(u, v));
      if((there.state & visited) != 0)
        note_meeting(v, u, distance);
      else if(distance < there.distance)
        reach(u, {distance, v, here.source, static_cast<std::uint8_t>(here.state & right)});
    }
  }

  void note_meeting(Index v, Index u, float distance) {
    const Label &here = labels_[v], &there = labels_[u];
    if(((here.state ^ there.state) & right) == 0)
      return;
    const double length = double(distance) + there.distance + along(here.source, there.source);
    if(length < best_.length)
      best_ = (here.state & right) != 0 ? Meeting{length, u, v} : Meeting{length, v, u};
  }

  double along(Index i, Index j) const {
    const std::vector<double>& position = parallel_paths_.along();
    const double one_way = std::abs(position[i] - position[j]);
    return (std::min)(one_way, position.back() - one_way);
  }

  // From `v` to a source.
  std::vector<Index> path_back(Index v) const {
    std::vector<Index> way;
    for(; v != no_index; v = labels_[v].parent) {
      CGAL_assertion(way.empty() || labels_[v].distance <= labels_[way.back()].distance);
      CGAL_assertion(way.empty() || ((labels_[v].state ^ labels_[way.back()].state) & right) == 0);
      way.push_back(v);
    }
    CGAL_assertion_msg((labels_[way.back()].state & beside_loop) != 0,
                       "a way ends beside the loop");
    return way;
  }

  void reset() {
    for(Index v : reached_)
      labels_[v] = Label();
    reached_.clear();
    queue_.clear();
  }

  const Flat_mesh& mesh_;
  std::vector<Label> labels_; // by vertex
  std::vector<Index> reached_;
  Queue queue_;
  Meeting best_{};
  Parallel_paths parallel_paths_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BIDIRECTIONAL_DIJKSTRA_H
