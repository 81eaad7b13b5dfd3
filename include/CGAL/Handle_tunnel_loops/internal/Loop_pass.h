// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/Narrow_band.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
The operation behind the tunnel pass and the refinement pass (paper, 4.2 and 4.3): find the way from
the left side of a loop around to its right side that crosses no wall, and close it across the loop.

The paper lets a field grow from one side until it reaches the other. Here it grows from both sides
until the two fronts meet: the way is as short, and the fronts cover a fraction of the region where
surfaces branch. From where they meet the way goes back to either side, each vertex followed by the
neighbour that was reached first, then across the loop, and along its left side, the short way, to
where it began.

The result crosses the loop once and no other wall, counted with sign. This is checked in integers
for every candidate; on meshes so coarse that an edge is crossed by several walls, the first meeting
may fail, and the next one is waited for.
*/
template <typename Loop_set> class Loop_pass
{
public:
  /// `index` tells where the loops are that can be barred: in each search a set of type `Loop_set`.
  Loop_pass(const Flat_mesh& mesh,
            const Stencils& stencils,
            const Step_coefficients& k,
            const Crossing_index& index)
      : mesh_(mesh)
      , index_(index)
      , band_(mesh, stencils, k) {
    if(!Loop_set::is_one)
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        if(index.has_crossing(v))
          band_.expect_walls(v);
  }

  /// How long to search.
  struct Limits
  {
    std::size_t number_of_walks = 1; ///< stop when so many are found
    Time number_of_steps = never;    ///< stop after so many steps
  };

  /// returns closed walks on the edges, the shortest first as far as the fronts can tell; `number`
  /// is that of `loop` in the index, and is among the `barred` ones, which are walls. Where the
  /// fronts meet in several places, as behind each of several branches of the surface, there is a
  /// walk for each; the search ends a third later than the first was found.
  std::vector<std::vector<Index>> dual_walks(const Crossing_loop& loop,
                                             Index number,
                                             const Loop_set& barred,
                                             const Limits& limits) {
    const Walls walls(index_, barred);
    measure(loop);
    start(loop, walls);
    std::vector<std::vector<Index>> walks;
    Time last_step = limits.number_of_steps;
    do {
      std::sort(meetings_.begin(), meetings_.end());
      for(const Meeting& meeting : meetings_) {
        if(walks.size() == limits.number_of_walks || continues_a_meeting(meeting))
          continue;
        std::vector<Index> walk = close(loop, meeting, walls);
        if(!is_dual(index_.intersections(walk), number, barred))
          continue;
        mark(meeting);
        if(walks.empty())
          last_step = (std::min)(last_step, band_.number_of_steps() * 4 / 3 + 1);
        walks.push_back(std::move(walk));
      }
      meetings_.clear();
    } while(walks.size() < limits.number_of_walks && band_.number_of_steps() < last_step &&
            band_.step(walls, [&](Index v) { note_meetings(v, walls); }));
    band_.reset();
    return walks;
  }

  std::size_t number_of_updates() const { return band_.number_of_updates(); }

private:
  using Walls = Loop_walls<Loop_set>;

  // An edge, or one vertex, at which what was reached from the left meets what was reached from the
  // right.
  struct Meeting
  {
    std::uint64_t time; // on both ways together
    Index left, right;

    bool operator<(const Meeting& other) const {
      return std::tie(time, left, right) < std::tie(other.time, other.left, other.right);
    }
  };

  void measure(const Crossing_loop& loop) {
    along_.resize(loop.size() + 1);
    along_[0] = 0.;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Index u = loop[i].left, v = loop[i + 1 == loop.size() ? 0 : i + 1].left;
      along_[i + 1] = along_[i] + mesh_.edge_length(u, v);
    }
  }

  void start(const Crossing_loop& loop, const Walls& walls) {
    meetings_.clear();
    for(const Crossing& c : loop)
      if(Loop_set::is_one) {
        band_.expect_walls_now(c.left);
        band_.expect_walls_now(c.right);
      }
    for(const Crossing& c : loop)
      band_.add_source(c.left, 0, Side::LEFT);
    for(const Crossing& c : loop)
      if(band_.is_reached(c.right) && band_.side(c.right) == Side::LEFT)
        meetings_.push_back({0, c.right, c.right});
      else
        band_.add_source(c.right, 0, Side::RIGHT);
    for(const Crossing& c : loop)
      if(band_.side(c.right) == Side::RIGHT)
        note_meetings(c.right, walls);
    band_.start(walls);
  }

  void note_meetings(Index v, const Walls& walls) {
    const Side side = band_.side(v);
    for(Index u : mesh_.ring(v))
      if(band_.is_reached(u) && band_.side(u) != side && !band_.is_wall(v, u, walls)) {
        const std::uint64_t time = std::uint64_t(band_.time(u)) + band_.time(v);
        meetings_.push_back(side == Side::RIGHT ? Meeting{time, u, v} : Meeting{time, v, u});
      }
  }

  // Once the fronts have met in one place, they go on meeting beside it.
  bool continues_a_meeting(const Meeting& meeting) {
    for(Index v : {meeting.left, meeting.right}) {
      bool is_marked = band_.is_marked(v);
      for(Index u : mesh_.ring(v))
        is_marked = is_marked || band_.is_marked(u);
      if(is_marked) {
        mark(meeting);
        return true;
      }
    }
    return false;
  }

  void mark(const Meeting& meeting) {
    band_.mark(meeting.left);
    band_.mark(meeting.right);
  }

  std::vector<Index>
  close(const Crossing_loop& loop, const Meeting& meeting, const Walls& walls) const {
    std::vector<Index> walk = way_back(meeting.right, walls);
    std::reverse(walk.begin(), walk.end());
    const std::vector<Index> to_left = way_back(meeting.left, walls);
    walk.insert(walk.end(), to_left.begin(), to_left.end());
    append_along(loop, walk.back(), walk.front(), walk);
    remove_spurs(walk);
    return walk;
  }

  // Whether loop `number` is crossed once, and no other wall.
  static bool is_dual(const Sparse_numbers& numbers, Index number, const Loop_set& barred) {
    bool is_crossed_once = false;
    for(const auto& [loop, count] : numbers)
      if(loop == number)
        is_crossed_once = std::abs(count) == 1;
      else if(barred.contains(loop))
        return false;
    return is_crossed_once;
  }

  // From `v` to a source, down the steepest edges. To follow the earliest neighbour instead would
  // drift along the longer edges, and wind around the loop.
  std::vector<Index> way_back(Index v, const Walls& walls) const {
    std::vector<Index> walk(1, v);
    while(band_.time(v) != 0) {
      Index next = v;
      double steepest = 0.;
      for(Index u : mesh_.ring(v)) {
        if(band_.time(u) >= band_.time(v) || band_.side(u) != band_.side(v) ||
           band_.is_wall(v, u, walls))
          continue;
        const double drop = band_.time(v) - band_.time(u), distance = mesh_.edge_length(u, v);
        const double slope = distance > 0. ? drop / distance : (std::numeric_limits<double>::max)();
        if(slope > steepest) {
          steepest = slope;
          next = u;
        }
      }
      v = next;
      walk.push_back(v);
    }
    return walk;
  }

  // Goes on from `left`, a vertex on the left side, along that side to beside `right`.
  void
  append_along(const Crossing_loop& loop, Index left, Index right, std::vector<Index>& walk) const {
    std::vector<std::size_t> starts, ends;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      if(loop[i].left == left)
        starts.push_back(i);
      if(loop[i].right == right)
        ends.push_back(i);
    }
    std::size_t from = starts.front(), to = ends.front();
    for(std::size_t i : starts)
      for(std::size_t j : ends)
        if(distance_along(i, j) < distance_along(from, to)) {
          from = i;
          to = j;
        }
    append_the_short_way(loop, from, to, walk);
  }

  double distance_along(std::size_t i, std::size_t j) const {
    const double d = std::abs(along_[i] - along_[j]);
    return (std::min)(d, along_.back() - d);
  }

  void append_the_short_way(const Crossing_loop& loop,
                            std::size_t from,
                            std::size_t to,
                            std::vector<Index>& walk) const {
    const std::size_t n = loop.size();
    const double forward = along_[to] - along_[from] + (to < from ? along_.back() : 0.);
    const bool go_forward = forward <= along_.back() - forward;
    for(std::size_t i = from; i != to;) {
      i = go_forward ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n - 1 : i - 1);
      walk.push_back(loop[i].left);
    }
  }

  const Flat_mesh& mesh_;
  const Crossing_index& index_;
  Narrow_band band_;
  std::vector<Meeting> meetings_;
  std::vector<double> along_; // length of the left side up to each crossing
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_PASS_H
