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
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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
      , paths_(mesh.number_of_vertices()) {}

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
    paths_.clear();
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
        if(!paths_.is_reached(v))
          paths_.reach(v, {0.f, no_index, i, static_cast<std::uint8_t>(beside_loop | side)});
      }
  }

  // Returns whether it came to an end.
  template <typename Walls> bool search(const Walls& walls, std::size_t number_of_visits) {
    bool is_done = true;
    paths_.grow([&](float distance) { return is_done && 2. * distance < best_.length; },
                [&](Index v) {
                  is_done = number_of_visits-- > 0;
                  if(is_done)
                    visit(v, walls);
                });
    return is_done;
  }

  template <typename Walls> void visit(Index v, const Walls& walls) {
    paths_[v].state |= visited;
    const Label here = paths_[v];
    for(Index u : mesh_.ring(v)) {
      const Label& there = paths_[u];
      if((here.state & there.state & beside_loop) != 0 && walls.is_wall(v, u))
        continue;
      const float distance = here.distance + static_cast<float>(mesh_.edge_length(u, v));
      if((there.state & visited) != 0)
        note_meeting(v, u, distance);
      else if(distance < there.distance)
        paths_.reach(u, {distance, v, here.source, static_cast<std::uint8_t>(here.state & right)});
    }
  }

  void note_meeting(Index v, Index u, float distance) {
    const Label &here = paths_[v], &there = paths_[u];
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
    for(; v != no_index; v = paths_[v].parent) {
      CGAL_assertion(way.empty() || paths_[v].distance <= paths_[way.back()].distance);
      CGAL_assertion(way.empty() || ((paths_[v].state ^ paths_[way.back()].state) & right) == 0);
      way.push_back(v);
    }
    CGAL_assertion_msg((paths_[way.back()].state & beside_loop) != 0, "a way ends beside the loop");
    return way;
  }

  const Flat_mesh& mesh_;
  Shortest_paths<Label> paths_; // by vertex
  Meeting best_{};
  Parallel_paths parallel_paths_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BIDIRECTIONAL_DIJKSTRA_H
