// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_FORMULAS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_FORMULAS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// \file saddle_formulas.h
/// What is computed at one vertex or one crossing of a contour, for host and device alike.

/// the number of maximal runs of vertices in a ring that are earlier than its center: 0 at a
/// minimum, at least 2 at a saddle; a maximum has one that is the whole ring, as a regular vertex
/// has one that is not. (A whole ring has no change, and counts 0 here too.)
template <typename Is_earlier>
CGAL_HTL_HOST_DEVICE Index count_lower_components(Ring ring, const Is_earlier& is_earlier) {
  bool previous = is_earlier(ring[ring.size() - 1]);
  Index changes = 0;
  for(Index i = 0; i < ring.size(); ++i) {
    const bool current = is_earlier(ring[i]);
    changes += current != previous;
    previous = current;
  }
  return changes / 2;
}

/// Contours pass edges at ratios away from the ends.
constexpr double smallest_ratio = 0.01, largest_ratio = 0.99;

/// where the contour at time `at` passes an edge.
CGAL_HTL_HOST_DEVICE inline Crossing
contour_crossing(Index left, Index right, Time time_left, Time time_right, Time at) {
  const double from = time_left, to = time_right;
  const double ratio = to > from ? (at - from) / (to - from) : 0.5;
  const double bounded = ratio < smallest_ratio ? smallest_ratio : ratio;
  return {left, right, bounded > largest_ratio ? largest_ratio : bounded};
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_FORMULAS_H
