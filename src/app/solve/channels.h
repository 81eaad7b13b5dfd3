// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHANNELS_H
#define HTLOOPS_CHANNELS_H

#include "solve/answer.h"

#include <cstddef>
#include <vector>

namespace htloops {

/// A way through the hole of a handle, outside of the solid: the part, around the throat, of the
/// curve of the clear width that is within the convex hull of the surface, or all of it.
struct Channel
{
  std::size_t pair;
  double diameter; ///< of the largest ball that comes through
  bool is_closed;
  std::vector<Point> points;
  std::vector<double> radii; ///< by point, of the largest ball around it that the surface leaves
};

/// the channels of the pairs whose clear width is known, with points not farther from each other
/// than half the radius of the throat. Takes a time that is about linear in faces and in points.
std::vector<Channel> find_channels(const Mesh& mesh, const Measures& measures);

/// the distances of points from the faces of a mesh, in any unit.
std::vector<double> distances_to_surface(const Mesh& mesh, const std::vector<Point>& points);

} // namespace htloops

#endif // HTLOOPS_CHANNELS_H
