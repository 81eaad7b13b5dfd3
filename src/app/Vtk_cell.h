// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VTK_CELL_H
#define HTLOOPS_VTK_CELL_H

namespace htloops {

/// What VTK calls the cells of a grid, as far as they are read or written here.
enum class Vtk_cell {
  VERTEX = 1,
  LINE = 3,
  POLYLINE = 4,
  TRIANGLE = 5,
  TRIANGLE_STRIP = 6,
  POLYGON = 7,
  PIXEL = 8,
  QUAD = 9,
  QUADRATIC_TRIANGLE = 22,
  QUADRATIC_QUAD = 23,
  BIQUADRATIC_QUAD = 28,
  BIQUADRATIC_TRIANGLE = 34
};

} // namespace htloops

#endif // HTLOOPS_VTK_CELL_H
