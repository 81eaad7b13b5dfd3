// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_COMPARE_FLAT_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_COMPARE_FLAT_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>

#include <CGAL/enum.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

/// whether loop a is shorter than loop b, exactly: for the choice between finished loops. Where
/// many are looked at on the way to these, `length()` is enough.
inline bool is_shorter(const Flat_mesh& mesh, const Crossing_loop& a, const Crossing_loop& b) {
  return compare_lengths(mesh, a, b) == SMALLER;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_COMPARE_FLAT_LOOPS_H
