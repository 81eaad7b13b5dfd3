// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_LENGTH_ACROSS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_LENGTH_ACROSS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

namespace CGAL::Handle_tunnel_loops::internal {

/// how long a curve across an edge is, by the way from the middle of one face there to that of the
/// other: three times that.
inline double length_across(const Flat_mesh& mesh, Index u, Index v) {
  const Ring ring = mesh.ring(u);
  const Index p = ring.position(v);
  return norm(mesh.points[ring[ring.next(p)]] - mesh.points[ring[ring.previous(p)]]);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_LENGTH_ACROSS_H
