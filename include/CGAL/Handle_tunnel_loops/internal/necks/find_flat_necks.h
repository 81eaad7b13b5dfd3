// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A neck of a flat mesh, in its unit.
struct Flat_neck
{
  Crossing_loop loop;
  double length;
  double smaller_area_share; ///< of the component, beyond the loop
};

/// What a neck is.
struct Neck_limits
{
  double maximal_length; ///< in the unit of the mesh
  double minimal_share;  ///< of the area of the component, for each of the pieces
};

/// finds necks: see `find_necks()`.
CGAL_HTL_CORE std::vector<Flat_neck>
find_flat_necks(Execution execution, const Flat_mesh& mesh, const Neck_limits& limits);

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/necks/find_flat_necks_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_H
