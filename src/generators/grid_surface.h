// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GRID_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GRID_SURFACE_H

#include "Field.h"
#include "generators.h"

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// The numbers of rings along a tube and of vertices around it.
struct Grid_size
{
  std::size_t along, around;
};

/// the grid of about a number of faces whose quadrangles are nearly square on a tube of which the
/// length is `aspect` times the circumference.
Grid_size grid_size(std::size_t faces, double aspect);

/// the torus of a grid that is periodic both ways, its quadrangles cut in two. It is oriented by
/// (along, around).
Soup grid_surface(Grid_size size,
                  const std::function<Vector(std::size_t along, std::size_t around)>& point);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GRID_SURFACE_H
