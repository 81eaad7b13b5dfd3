// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_STROKE_H
#define HTL_PICTURE_STROKE_H

#include "picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace htl_picture {

/// A straight line on the picture, from one place to another, in pixels.
struct Stroke
{
  std::array<float, 2> from, to;
  float width;
  Colour colour;

  float distance(float x, float y) const {
    const float dx = to[0] - from[0], dy = to[1] - from[1], squared = dx * dx + dy * dy;
    const float along = (x - from[0]) * dx + (y - from[1]) * dy;
    const float t = squared > 0.f ? std::clamp(along / squared, 0.f, 1.f) : 0.f;
    return std::hypot(x - from[0] - t * dx, y - from[1] - t * dy);
  }

  bool meets(const Stroke& other) const {
    const auto side = [](const Stroke& s, const std::array<float, 2>& p) {
      return (s.to[0] - s.from[0]) * (p[1] - s.from[1]) -
             (s.to[1] - s.from[1]) * (p[0] - s.from[0]);
    };
    return side(*this, other.from) * side(*this, other.to) <= 0.f &&
           side(other, from) * side(other, to) <= 0.f;
  }
};

/// A circle on the picture, in pixels.
struct Ring
{
  float x, y, radius, width;
  Colour colour;

  float distance(float u, float v) const { return std::abs(std::hypot(u - x, v - y) - radius); }
};

} // namespace htl_picture

#endif // HTL_PICTURE_STROKE_H
