// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ARC_SURFACE_H
#define HTLOOPS_ARC_SURFACE_H

#include "draw/mesh_arrays.h"
#include "mesh_types.h"
#include "solve/reeb_answer.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htloops {

/// The surface in pieces each of which belongs to one arc: faces are cut along the contours where
/// fronts meet, so that the border of a part is as smooth as the function.
struct Arc_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangle_arcs;
};

Arc_surface arc_surface(const Mesh& mesh, const Reeb_answer& answer);

/// the same in the colours of the arcs.
Drawn_surface drawn_surface(const Arc_surface& surface);

} // namespace htloops

#endif // HTLOOPS_ARC_SURFACE_H
