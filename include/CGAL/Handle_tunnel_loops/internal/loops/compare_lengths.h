// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_COMPARE_LENGTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_COMPARE_LENGTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Edge_place.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>

#include <CGAL/enum.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// compares the lengths of two closed polylines through such points, exactly.
CGAL_HTL_CORE Comparison_result compare_lengths(const std::vector<Edge_place>& a,
                                                const std::vector<Edge_place>& b);

/// the ends of an interval that holds the length of a closed polyline through such points.
CGAL_HTL_CORE std::pair<double, double> length_interval(const std::vector<Edge_place>& places);

/// compares the lengths of two loops, exactly.
inline Comparison_result
compare_lengths(const Flat_mesh& mesh, const Crossing_loop& a, const Crossing_loop& b) {
  return compare_lengths(edge_places(mesh, a), edge_places(mesh, b));
}

/// whether loop a is shorter than loop b, exactly: for the choice between finished loops. Where
/// many are looked at on the way to these, `length()` is enough.
inline bool is_shorter(const Flat_mesh& mesh, const Crossing_loop& a, const Crossing_loop& b) {
  return compare_lengths(mesh, a, b) == SMALLER;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/loops/compare_lengths_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_COMPARE_LENGTHS_H
