// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SOLVER_ACCESS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SOLVER_ACCESS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Lets what cuts a surface open use the arrays in which a solver keeps it.
struct Solver_access
{
  template <typename Solver> static const Flat_mesh& mesh(const Solver& solver) {
    return solver.mesh_;
  }
  /// the vertex of each index of the flat mesh.
  template <typename Solver> static const auto& vertices(const Solver& solver) {
    return solver.vertices_;
  }
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SOLVER_ACCESS_H
