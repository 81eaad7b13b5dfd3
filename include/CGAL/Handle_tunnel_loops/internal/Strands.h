// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_STRANDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_STRANDS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Front.h>
#include <CGAL/Handle_tunnel_loops/internal/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/Sweep_stars.h>
#include <CGAL/Handle_tunnel_loops/internal/Wedges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The parts of the contours through a vertex that lie outside of its star: strand i leaves at the
/// clockwise end of wedge i, keeps the lower side on its left, and comes back at the
/// counterclockwise end of wedge `arrival`. Below the vertex the strands are joined around the
/// wedges, above it around the gaps between them.
struct Strand
{
  Index arrival;
  Index arc; ///< before the vertex is passed, that of the contour below; then that of the one above
  Front front; ///< of the strand alone
};

using Strands = std::vector<Strand>;

/// A vertex and its wedges, when the sweep has come to it.
class Crossroads
{
public:
  Crossroads(const Flat_mesh& mesh, const Sweep_order& order, Index center)
      : mesh_(mesh)
      , center_(center)
      , ring_(mesh.ring(center))
      , wedges_(find_wedges(ring_,
                            [&](Index p) { return order.rank(ring_[p]) < order.rank(center); })) {
    for(Index i = 0; i < number_of_wedges(); ++i)
      ends_.emplace_back(ring_[wedges_[i].last], i);
    std::sort(ends_.begin(), ends_.end());
  }

  Index center() const { return center_; }
  Index number_of_wedges() const { return static_cast<Index>(wedges_.size()); }
  Index next_wedge(Index i) const { return i + 1 == number_of_wedges() ? 0 : i + 1; }

  /// the vertices of wedge i at its clockwise end, and after it clockwise.
  Index first_of(Index i) const { return ring_[wedges_[i].first]; }
  Index before_first_of(Index i) const { return ring_[ring_.previous(wedges_[i].first)]; }

  /// the wedge whose counterclockwise end is \p v.
  Index wedge_that_ends_at(Index v) const {
    return std::lower_bound(ends_.begin(), ends_.end(), std::make_pair(v, Index(0)))->second;
  }

  /// calls `f(p)` for the positions of wedge i, counterclockwise.
  template <typename Function> void for_each_below(Index i, const Function& f) const {
    for(Index p = wedges_[i].first; p != ring_.next(wedges_[i].last); p = ring_.next(p))
      f(p);
  }

  /// calls `f(p)` for the positions in the gap after wedge i, counterclockwise.
  template <typename Function> void for_each_above(Index i, const Function& f) const {
    for(Index p = ring_.next(wedges_[i].last); p != wedges_[next_wedge(i)].first; p = ring_.next(p))
      f(p);
  }

  Front front_below(Index i) const {
    Front front;
    for_each_below(i, [&](Index p) { front += crossing_of_front(mesh_, center_, ring_, p); });
    return front;
  }

  Front front_above(Index i) const {
    Front front;
    for_each_above(i, [&](Index p) { front += crossing_of_front(mesh_, center_, ring_, p); });
    return front;
  }

  /// the slot of the edge from the neighbour at a position, which is lower, to the center.
  Index slot_below(Index position) const { return slot_of(mesh_, ring_[position], center_); }

  /// the slot of the edge from the center to the neighbour at a position, which is higher.
  Index slot_above(Index position) const { return mesh_.row_begin[center_] + position; }

  /// the slot of any edge of wedge i.
  Index slot_of_wedge(Index i) const { return slot_below(wedges_[i].first); }

private:
  const Flat_mesh& mesh_;
  Index center_;
  Ring ring_;
  Wedges wedges_;
  boost::container::small_vector<std::pair<Index, Index>, 4> ends_; // sorted (vertex, wedge)
};

/// A walk along a contour, from edge to edge, with the lower ends on the left.
class Contour_walk
{
public:
  /// begins at an edge with its lower end first; lower are the vertices of ranks below \p level.
  Contour_walk(
      const Flat_mesh& mesh, const Sweep_order& order, Index level, Index left, Index right)
      : mesh_(&mesh)
      , order_(&order)
      , level_(level)
      , left_(left)
      , position_(mesh.ring(left).position(right)) {}

  Index left() const { return left_; }
  Index position() const { return position_; }
  Index slot() const { return mesh_->row_begin[left_] + position_; }

  /// goes on to the next edge; returns false, and stays, if that leads to the star of \p center.
  bool advance(Index center) {
    const Ring ring = mesh_->ring(left_);
    const Index next = ring.next(position_), apex = ring[next];
    if(apex == center)
      return false;
    if(order_->rank(apex) >= level_)
      position_ = next;
    else {
      const Index right = ring[position_];
      left_ = apex;
      position_ = mesh_->ring(apex).position(right);
    }
    return true;
  }

private:
  const Flat_mesh* mesh_;
  const Sweep_order* order_;
  Index level_;
  Index left_, position_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_STRANDS_H
