// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SPREAD_LINES_H
#define HTLOOPS_SPREAD_LINES_H

#include "draw/surfaces.h"
#include "scene/scene.h"

#include <vector>

namespace htloops {

/// How far lines inside a surface are spread over a picture, all parts of which are looked through.
class Spread_lines
{
public:
  Spread_lines(const htl_scene::Surface& surface, const std::vector<std::vector<Vector>>& lines);

  /// What is covered of a square around the surface, 0 to 1.
  struct View
  {
    double lines = 0.; ///< by lines of some width: once, however many there are before each other
    double surface = 0.;
  };

  /// \p from has length one.
  View look_from(const Vector& from) const;

private:
  std::vector<Vector> on_lines_, on_surface_; // points, in the unit ball
};

} // namespace htloops

#endif // HTLOOPS_SPREAD_LINES_H
