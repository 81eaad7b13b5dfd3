// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_SWEPT_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_SWEPT_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What a sweep tells of each vertex; empty where nobody asks.
struct Swept_vertices
{
  std::vector<Index> layers; ///< from 1, see `Front_log`
  std::vector<double> times; ///< in steps of the field
};

inline std::vector<double> times_in_steps(const std::vector<Time>& times) {
  std::vector<double> steps(times.size());
  std::transform(times.begin(), times.end(), steps.begin(),
                 [](Time time) { return double(time) / ticks_per_step; });
  return steps;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_SWEPT_VERTICES_H
