// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/Arrival_order.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Lower_link_components.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/saddle_formulas.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <boost/container/small_vector.hpp>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the number of maximal runs of earlier vertices around `v`.
inline Index count_lower_components(const Flat_mesh& mesh, const Arrival_order& order, Index v) {
  return count_lower_components(mesh.ring(v), [&](Index u) { return order.is_earlier(u, v); });
}

template <typename Execution>
std::vector<Index>
find_saddles(Execution execution, const Flat_mesh& mesh, const Arrival_order& order) {
  return collect<Index>(execution, mesh.number_of_vertices(),
                        [&](std::size_t begin, std::size_t end) {
                          std::vector<Index> saddles;
                          for(std::size_t v = begin; v < end; ++v)
                            if(count_lower_components(mesh, order, static_cast<Index>(v)) > 1)
                              saddles.push_back(static_cast<Index>(v));
                          return saddles;
                        });
}

/*!
The contours that meet at a saddle.

The earlier neighbours of the saddle form k >= 2 lower components around it. Outside of its star,
the contour at its level consists of k arcs; arc i leaves across the edge at the clockwise end of
lower component i, keeps the earlier side on its left, and arrives at the counterclockwise end of
lower component `arrival(i)`. Just below the level the arcs are joined around the lower components,
just above it around the gaps between them. So the permutation `arrival` says which contours meet
and which part.

The arcs are walked in turns until all but one have arrived; which lower component the last one
comes to is then clear, and the longest arc is never walked to its end.
*/
class Saddle
{
public:
  Saddle(const Flat_mesh& mesh, const Arrival_order& order, Index center)
      : mesh_(mesh)
      , order_(order)
      , center_(center)
      , ring_(mesh.ring(center))
      , lower_components_(find_lower_components(ring_, [this](Index p) { return is_lower(p); })) {
    walk_arcs();
  }

  Index center() const { return center_; }
  Index number_of_lower_components() const { return static_cast<Index>(lower_components_.size()); }

  /// the lower component at which the arc that leaves lower component `i` arrives.
  Index arrival(Index i) const { return arcs_[i].arrival; }

  /// whether the arc that leaves lower component `i` is the one that was not walked to its end.
  bool is_longest(Index i) const { return i == longest_; }

  const Crossing_loop& arc(Index i) const { return arcs_[i].crossings; }

  /// a vertex of lower component `i`.
  Index lower_component_vertex(Index i) const { return ring_[lower_components_[i].first]; }

  /// passes from the counterclockwise end of lower component `from` clockwise to the clockwise end
  /// of lower component `to`, keeping the saddle on the right.
  void append_clockwise(Index from, Index to, Crossing_loop& loop) const {
    for(Index p = lower_components_[from].last;; p = ring_.previous(p)) {
      loop.push_back({ring_[p], center_, largest_ratio});
      if(p == lower_components_[to].first)
        break;
    }
  }

  /// passes from the counterclockwise end of lower component `from` counterclockwise over the gap
  /// to the next lower component, keeping the saddle on the left.
  void append_counterclockwise(Index from, Crossing_loop& loop) const {
    const Index end =
        lower_components_[from + 1 == number_of_lower_components() ? 0 : from + 1].first;
    for(Index p = ring_.next(lower_components_[from].last); p != end; p = ring_.next(p))
      loop.push_back({center_, ring_[p], smallest_ratio});
  }

private:
  struct Arc
  {
    Crossing_loop crossings;
    Index arrival = no_index;
  };

  bool is_lower(Index p) const { return order_.is_earlier(ring_[p], center_); }

  void walk_arcs() {
    const Index k = number_of_lower_components();
    arcs_.resize(k);
    for(Index i = 0; i < k; ++i) {
      const Index first = lower_components_[i].first;
      append(arcs_[i].crossings, ring_[first], ring_[ring_.previous(first)]);
    }
    Index arrived = 0;
    while(arrived + 1 < k)
      for(Index i = 0; i < k && arrived + 1 < k; ++i)
        if(arcs_[i].arrival == no_index && advance(arcs_[i]))
          ++arrived;
    settle_longest();
  }

  void append(Crossing_loop& arc, Index left, Index right) const {
    arc.push_back(
        contour_crossing(left, right, order_.time(left), order_.time(right), order_.time(center_)));
  }

  bool advance(Arc& arc) const {
    const Crossing last = arc.crossings.back();
    const Index apex = apex_ahead(mesh_, last);
    if(apex == center_) {
      arc.arrival = lower_component_that_ends_at(last.left);
      return true;
    }
    if(order_.is_earlier(apex, center_))
      append(arc.crossings, apex, last.right);
    else
      append(arc.crossings, last.left, apex);
    return false;
  }

  Index lower_component_that_ends_at(Index v) const {
    Index i = 0;
    while(ring_[lower_components_[i].last] != v)
      ++i;
    return i;
  }

  void settle_longest() {
    boost::container::small_vector<char, 8> is_taken(arcs_.size(), 0);
    for(Index i = 0; i < arcs_.size(); ++i)
      if(arcs_[i].arrival == no_index)
        longest_ = i;
      else
        is_taken[arcs_[i].arrival] = 1;
    Index free = 0;
    while(is_taken[free])
      ++free;
    arcs_[longest_].arrival = free;
  }

  const Flat_mesh& mesh_;
  const Arrival_order& order_;
  Index center_;
  Ring ring_;
  Lower_link_components lower_components_;
  boost::container::small_vector<Arc, 4> arcs_;
  Index longest_ = 0;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_H
