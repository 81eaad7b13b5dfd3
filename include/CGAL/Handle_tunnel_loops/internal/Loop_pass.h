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

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
The operation behind the tunnel pass and the refinement pass (paper, 4.2 and 4.3): diffuse from the
left side of a loop, across no wall, until a vertex on its right side is reached; go back from there to
the left side, each vertex followed by the neighbour that was reached first; along the left side to where
the vertex is, the short way; and across the loop.

The result crosses the loop once and no other wall, counted with sign. This is checked in integers for
every candidate; on meshes so coarse that an edge is crossed by several walls, the first vertex reached
may fail, and the next one is waited for.
*/
class Loop_pass
{
public:
  Loop_pass(const Flat_mesh& mesh, const std::vector<float>& speed, const Step_coefficients& k)
    : mesh_(mesh)
    , band_(mesh, speed, k) {}

  /// returns a closed walk on the edges, empty if there is none; `number` is that of `loop` in
  /// `index`, and loops `number` to `last - 1` are walls.
  std::vector<Index> dual_walk(const Crossing_loop& loop, Index number, Index last,
                               const Crossing_index& index)
  {
    const Loop_walls walls(index, number, last);
    set_up(loop, walls);
    std::vector<Index> walk;
    std::vector<Index> reached;
    for(const Crossing& c : loop)
      if(band_.time(c.right) != never)
        reached.push_back(c.right);
    do {
      for(Index v : reached)
        if(walk.empty())
          walk = close(loop, v, number, last, index, walls);
      reached.clear();
    } while(walk.empty() && band_.step(walls, [&](Index v) {
      if(walls.may_have_wall(v) && index.is_on_right(v, number))
        reached.push_back(v);
    }));
    band_.reset();
    return walk;
  }

  std::size_t number_of_updates() const { return band_.number_of_updates(); }

private:
  void set_up(const Crossing_loop& loop, const Loop_walls& walls)
  {
    for(const Crossing& c : loop)
      band_.add_source(c.left, 0, walls);
    band_.start(walls);
    along_.resize(loop.size() + 1);
    along_[0] = 0.;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Index u = loop[i].left, v = loop[i + 1 == loop.size() ? 0 : i + 1].left;
      along_[i + 1] = along_[i] + mesh_.edge_length(u, v);
    }
  }

  std::vector<Index> close(const Crossing_loop& loop, Index v, Index number, Index last,
                           const Crossing_index& index, const Loop_walls& walls) const
  {
    const std::vector<Index> back = way_back(v, walls);
    for(std::size_t to = 0; to < loop.size(); ++to) {
      if(loop[to].right != v)
        continue;
      std::vector<Index> walk = back;
      append_along(loop, nearest_place(loop, back.back(), to), to, walk);
      remove_spurs(walk);
      if(is_dual(index.intersections(walk), number, last))
        return walk;
    }
    return {};
  }

  static bool is_dual(const Sparse_numbers& numbers, Index number, Index last)
  {
    auto it = numbers.lower_bound(number);
    if(it == numbers.end() || it->first != number || std::abs(it->second) != 1)
      return false;
    ++it;
    return it == numbers.end() || it->first >= last;
  }

  std::vector<Index> way_back(Index v, const Loop_walls& walls) const
  {
    std::vector<Index> walk(1, v);
    while(band_.time(v) != 0) {
      const bool near_wall = walls.may_have_wall(v);
      Index first = v;
      for(Index u : mesh_.ring(v))
        if(band_.time(u) < band_.time(first) && !(near_wall && walls.is_wall(v, u)))
          first = u;
      v = first;
      walk.push_back(v);
    }
    return walk;
  }

  double distance_along(std::size_t i, std::size_t j) const
  {
    const double d = std::abs(along_[i] - along_[j]);
    return (std::min)(d, along_.back() - d);
  }

  std::size_t nearest_place(const Crossing_loop& loop, Index left, std::size_t to) const
  {
    std::size_t nearest = loop.size();
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(loop[i].left == left &&
         (nearest == loop.size() || distance_along(i, to) < distance_along(nearest, to)))
        nearest = i;
    return nearest;
  }

  void append_along(const Crossing_loop& loop, std::size_t from, std::size_t to,
                    std::vector<Index>& walk) const
  {
    const std::size_t n = loop.size();
    const double forward = along_[to] - along_[from] + (to < from ? along_.back() : 0.);
    const bool go_forward = forward <= along_.back() - forward;
    for(std::size_t i = from; i != to;) {
      i = go_forward ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n - 1 : i - 1);
      walk.push_back(loop[i].left);
    }
  }

  const Flat_mesh& mesh_;
  Narrow_band band_;
  std::vector<double> along_; // length of the left side up to each crossing
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_PASS_H
