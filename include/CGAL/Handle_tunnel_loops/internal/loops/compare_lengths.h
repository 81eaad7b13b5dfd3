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
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>

#include <CGAL/enum.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The point `p + ratio (q - p)`, exactly.
struct Edge_place
{
  Vector p, q;
  double ratio;
};

/// compares the lengths of two closed polylines through such points, exactly.
CGAL_HTL_CORE Comparison_result compare_lengths(const std::vector<Edge_place>& a,
                                                const std::vector<Edge_place>& b);

inline std::vector<Edge_place> edge_places(const Flat_mesh& mesh, const Crossing_loop& loop) {
  std::vector<Edge_place> places;
  places.reserve(loop.size());
  for(const Crossing& c : loop)
    places.push_back({mesh.points[c.left], mesh.points[c.right], ratio_on_surface(mesh, c)});
  return places;
}

/// compares the lengths of two loops, exactly.
inline Comparison_result
compare_lengths(const Flat_mesh& mesh, const Crossing_loop& a, const Crossing_loop& b) {
  return compare_lengths(edge_places(mesh, a), edge_places(mesh, b));
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/loops/compare_lengths_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_COMPARE_LENGTHS_H
