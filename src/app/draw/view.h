// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VIEW_H
#define HTLOOPS_VIEW_H

#include "scene/scene.h"

#include <array>
#include <vector>

namespace htloops {

/// How a surface is seen, in a picture, or at first on a page. Empty for the default.
struct View
{
  std::vector<double> from; ///< the direction from the surface to the eye
  std::vector<double> up;   ///< the direction that is upright
  std::vector<std::vector<std::array<double, 3>>> chosen; ///< lines that are to be seen
};

/// A view without defaults.
struct Whole_view
{
  std::array<double, 3> from, up;
};

/// what was given; of what was not, z is upright, and the surface is seen from a little above, from
/// where most of the chosen lines is visible, and the largest part of the surface. That is found by
/// samples: the time is linear in the size of the mesh.
Whole_view whole_view(const View& given, const htl_scene::Surface& surface);

} // namespace htloops

#endif // HTLOOPS_VIEW_H
