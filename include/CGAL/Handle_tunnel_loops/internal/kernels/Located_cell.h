// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_LOCATED_CELL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_LOCATED_CELL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// A cell of a field, the vertex that it stands for, and the pass that it belongs to: looked up
/// once, and then passed on.
struct Located_cell
{
  Index cell, vertex, pass;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_LOCATED_CELL_H
