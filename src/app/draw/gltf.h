// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_GLTF_H
#define HTLOOPS_GLTF_H

#include "draw/lines.h"
#include "draw/surfaces.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// Triangles with a normal for each point.
struct Smooth_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 3>> normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// the tube around a line with a radius at each of its points, eight-sided; that of an open line is
/// open at its ends.
Smooth_surface tube_around(const std::vector<std::array<double, 3>>& line,
                           bool is_closed,
                           const std::vector<double>& radii);

/// the same with one radius.
Smooth_surface
tube_around(const std::vector<std::array<double, 3>>& line, bool is_closed, double radius);

Smooth_surface ball_around(const std::array<double, 3>& middle, double radius);

/// writes a surface and tubes around lines as a binary file of glTF 2.0, each line a node with its
/// name; balls around those of one point. Throws `Failure` if the surface is too large or too small
/// for the numbers of that format.
void export_gltf(const std::string& file,
                 const Drawn_surface& surface,
                 const Exported_lines& lines);

} // namespace htloops

#endif // HTLOOPS_GLTF_H
