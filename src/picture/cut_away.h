// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_CUT_AWAY_H
#define HTL_PICTURE_CUT_AWAY_H

#include "Camera.h"
#include "picture.h"

#include <vector>

namespace htl_picture {

/// What is left of a surface and lines.
struct Rest
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Colour> triangle_colours;
  std::vector<Line> lines;
};

/// what is not nearer to the eye than a height in the camera's frame; of lines that have radii,
/// those no point of which is.
Rest rest_below(float height,
                const Camera& camera,
                const std::vector<Point>& points,
                const std::vector<Triangle>& triangles,
                const std::vector<Colour>& triangle_colours,
                const std::vector<Line>& lines);

} // namespace htl_picture

#endif // HTL_PICTURE_CUT_AWAY_H
