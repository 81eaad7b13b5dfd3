// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_ARRAYS_H
#define HTLOOPS_MESH_ARRAYS_H

#include "mesh_types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htloops {

// Meshes as pictures and pages take them.

inline std::array<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<std::array<double, 3>> coordinates(const std::vector<Point>& points);

std::vector<std::array<double, 3>> points_of(const Mesh& mesh);

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh);

/// What is drawn of a surface.
struct Drawn_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<unsigned char, 3>> colours; ///< of the triangles, or none
};

inline Drawn_surface drawn_surface(const Mesh& mesh) {
  return {points_of(mesh), triangles_of(mesh), {}};
}

} // namespace htloops

#endif // HTLOOPS_MESH_ARRAYS_H
