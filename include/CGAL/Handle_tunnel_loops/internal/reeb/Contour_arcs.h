// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_ARCS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_ARCS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A maximal run of lower vertices around a saddle, by its ends: positions in the ring,
/// counterclockwise.
struct Lower_component
{
  Index first, last;
};

using Lower_link_components = boost::container::small_vector<Lower_component, 4>;

/// the lower components of a ring that has lower and higher vertices; `is_lower` is asked about
/// positions.
template <typename IsLower>
Lower_link_components find_lower_components(Ring ring, const IsLower& is_lower) {
  Index start = 0;
  while(is_lower(start) || !is_lower(ring.next(start))) {
    ++start; // a higher vertex before a lower one
    CGAL_precondition_msg(start < ring.size(), "some vertices are lower and some are higher");
  }
  Lower_link_components lower_components;
  Index p = start;
  do {
    const Index q = ring.next(p);
    if(!is_lower(p) && is_lower(q))
      lower_components.push_back({q, q});
    else if(is_lower(q))
      lower_components.back().last = q;
    p = q;
  } while(p != start);
  return lower_components;
}

/// The parts of the contours through a vertex that lie outside of its star: contour arc i leaves at
/// the clockwise end of lower component i, keeps the lower side on its left, and comes back at the
/// counterclockwise end of lower component `arrival`. Below the vertex the contour arcs are joined
/// around the lower components, above it around the gaps between them.
///
/// A contour may end at a hole. The contour arc that leads there does not arrive; one that comes
/// from there leaves at no lower component, and stands after those that do. At a hole beside the
/// vertex itself, such contour arcs are empty.
struct Contour_arc
{
  Index arrival; ///< none at a hole
  Index
      arc; ///< before the vertex is passed, that of the contour below; then that of the one above;
           ///< none of a contour that is only the vertex, where it comes to a hole or leaves it
  Front_mean front; ///< of the contour arc alone
  bool is_empty = false;
};

using Contour_arcs = std::vector<Contour_arc>;

/// A vertex and its lower components, when the sweep has come to it.
class Swept_vertex
{
public:
  Swept_vertex(const Flat_mesh& mesh, const Sweep_order& order, Index center)
      : mesh_(mesh)
      , order_(order)
      , center_(center)
      , ring_(mesh.ring(center))
      , lower_components_(find_lower_components(ring_, [&](Index p) {
        return is_in_lower_component(order, ring_, p, order.rank(center));
      })) {
    for(Index i = 0; i < number_of_lower_components(); ++i)
      ends_.emplace_back(ring_[lower_components_[i].last], i);
    std::sort(ends_.begin(), ends_.end());
  }

  Index center() const { return center_; }
  Index number_of_lower_components() const { return static_cast<Index>(lower_components_.size()); }
  Index next_lower_component(Index i) const {
    return i + 1 == number_of_lower_components() ? 0 : i + 1;
  }

  /// the vertices of lower component i at its clockwise end, and after it clockwise.
  Index first_of(Index i) const { return ring_[lower_components_[i].first]; }
  Index before_first_of(Index i) const { return ring_[ring_.previous(lower_components_[i].first)]; }

  /// the vertices of lower component i at its counterclockwise end, and after it counterclockwise.
  Index last_of(Index i) const { return ring_[lower_components_[i].last]; }
  Index after_last_of(Index i) const { return ring_[ring_.next(lower_components_[i].last)]; }

  /// whether lower component i is only a hole.
  bool is_hole(Index i) const { return order_.is_hole(first_of(i)); }

  /// whether a contour ends where it leaves lower component i, or begins where it arrives there.
  bool leaves_to_hole(Index i) const { return is_hole(i) || order_.is_hole(before_first_of(i)); }
  bool arrives_from_hole(Index i) const { return is_hole(i) || order_.is_hole(after_last_of(i)); }

  /// the lower component whose counterclockwise end is \p v, if there is one.
  Index lower_component_that_ends_at(Index v) const {
    const auto it = std::lower_bound(ends_.begin(), ends_.end(), std::make_pair(v, Index(0)));
    CGAL_assertion_msg(order_.has_holes() || (it != ends_.end() && it->first == v),
                       "a contour arrives at the end of a lower component");
    return it != ends_.end() && it->first == v ? it->second : no_index;
  }

  /// calls `f(p)` for the positions of lower component i, counterclockwise; not for holes.
  template <typename Function> void for_each_below(Index i, const Function& f) const {
    for_each_between(lower_components_[i].first, ring_.next(lower_components_[i].last), f);
  }

  /// calls `f(p)` for the positions in the gap after lower component i, counterclockwise; not for
  /// holes.
  template <typename Function> void for_each_above(Index i, const Function& f) const {
    for_each_between(ring_.next(lower_components_[i].last),
                     lower_components_[next_lower_component(i)].first, f);
  }

  Front_mean front_below(Index i) const {
    Front_mean front;
    for_each_below(i,
                   [&](Index p) { front += crossing_of_front(mesh_, order_, center_, ring_, p); });
    return front;
  }

  Front_mean front_above(Index i) const {
    Front_mean front;
    for_each_above(i,
                   [&](Index p) { front += crossing_of_front(mesh_, order_, center_, ring_, p); });
    return front;
  }

  /// the slot of the edge from the neighbour at a position, which is lower, to the center.
  Index slot_below(Index position) const { return slot_of(mesh_, ring_[position], center_); }

  /// the slot of the edge from the center to the neighbour at a position, which is higher.
  Index slot_above(Index position) const { return mesh_.row_begin[center_] + position; }

  /// the slot of any edge of lower component i.
  Index slot_of_lower_component(Index i) const { return slot_below(lower_components_[i].first); }

private:
  template <typename Function> void for_each_between(Index p, Index end, const Function& f) const {
    for(; p != end; p = ring_.next(p))
      if(!order_.is_hole(ring_[p]))
        f(p);
  }

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  Index center_;
  Ring ring_;
  Lower_link_components lower_components_;
  boost::container::small_vector<std::pair<Index, Index>, 4>
      ends_; // sorted (vertex, lower component)
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
      , position_(mesh.position(left, right)) {
    CGAL_precondition(position_ < mesh.ring(left).size());
    CGAL_precondition(order.rank(left) < level && order.rank(right) >= level);
  }

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
      position_ = mesh_->position(apex, right);
      CGAL_assertion(position_ < mesh_->ring(apex).size());
    }
    return true;
  }

private:
  const Flat_mesh* mesh_;
  const Sweep_order* order_;
  Index level_;
  Index left_, position_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_ARCS_H
