// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_FLAT_SKELETON_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_FLAT_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A curve skeleton as plain arrays. Its points have the coordinates of the caller: what is proved
/// of them is proved of what the caller is given.
struct Flat_skeleton
{
  std::vector<Vector> points;
  std::vector<double> radii;               ///< by point
  std::vector<std::array<Index, 2>> edges; ///< between points
  std::vector<Index> component_of;         ///< by point, the number of a component of the mesh
  std::vector<char> is_inlet;              ///< by point, whether it is the hub of a cap
};

/// the number of a component, of whatever size; that of none if it is too large.
inline Index component_number(std::size_t c) { return c < no_index ? Index(c) : no_index; }

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_FLAT_SKELETON_H
