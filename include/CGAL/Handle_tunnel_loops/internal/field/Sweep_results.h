// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SWEEP_RESULTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SWEEP_RESULTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Two different contours meet at a saddle: a handle. `loop` is the shorter of the two, just below
/// the saddle, with the earlier side on its left.
struct Handle_candidate
{
  Crossing_loop loop;
  Index saddle;
  Index foot_a, foot_b; ///< earlier neighbours of the saddle, within either contour
};

/// The fronts of a sweep. Each lies in a layer from the event, or the minimum, with which it begins
/// to the event with which it ends; layers are numbered from 1 in the order in which they begin.
struct Front_log
{
  std::vector<Front_event> events; ///< in the order of arrival
  std::vector<Index> layer;        ///< by vertex; where a front ends, that of the front, or of one
};

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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SWEEP_RESULTS_H
