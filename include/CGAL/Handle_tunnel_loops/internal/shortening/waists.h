// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAISTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAISTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the boundary curve around a hub, the surface to its left.
Crossing_loop boundary_curve(const Flat_mesh& mesh, Index hub);

/// the same as a closed walk along edges.
std::vector<Index> boundary_walk(const Flat_mesh& mesh, Index hub);

/// the curve a little inside of the surface. It enters no cap.
Crossing_loop beside_boundary(const Flat_mesh& mesh, Index hub);

/// the hubs of the boundary curves of each component but for the last.
std::vector<Index> hubs_of_basis(const Flat_mesh& mesh);

/// the waists of all boundary curves; empty where the curve is the only one of its component, as a
/// point is homologous to it.
std::vector<Crossing_loop> waists(Execution execution, const Flat_mesh& mesh);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAISTS_H
