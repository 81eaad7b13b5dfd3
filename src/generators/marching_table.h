// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_MARCHING_TABLE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_MARCHING_TABLE_H

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// An edge of a cell of the lattice: it starts at corner `base` and goes along `direction`, where
/// both are sums of basis vectors as in `Bcc_lattice` and have no basis vector in common.
struct Cell_edge
{
  std::uint8_t base, direction;
};

using Cell_triangle = std::array<Cell_edge, 3>;

/// the triangles that separate the corners whose bits are set in `inside` from the others in the
/// six tetrahedra of a cell, seen counterclockwise from the outside.
const std::vector<Cell_triangle>& cell_triangles(unsigned inside);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_MARCHING_TABLE_H
