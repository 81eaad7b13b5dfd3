// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LOG_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LOG_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The fronts of a sweep. Each lies in a layer from the event, or the minimum, with which it begins
/// to the event with which it ends; layers are numbered from 1 in the order in which they begin.
struct Front_log
{
  std::vector<Front_event> events; ///< in the order of arrival
  std::vector<Index> layer;        ///< by vertex; where a front ends, that of the front, or of one
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LOG_H
