// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SKELETON_LINES_H
#define HTLOOPS_SKELETON_LINES_H

#include "mesh_types.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// A curve skeleton that was drawn elsewhere: segments between points.
struct Skeleton_lines
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::string> names;      ///< of the points, as their file has them
  std::vector<std::size_t> components; ///< of the mesh, by point; empty if that is not known
  std::vector<char> is_inlet;          ///< by point; empty if that is not known
};

} // namespace htloops

#endif // HTLOOPS_SKELETON_LINES_H
