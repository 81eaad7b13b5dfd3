// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_SURFACE_LAYER_H
#define HTL_PICTURE_SURFACE_LAYER_H

#include "Camera.h"
#include "picture.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace htl_picture {

/// What of a mesh is seen at each sample of a picture: the nearest triangle and how near it is.
class Surface_layer
{
public:
  static constexpr std::uint32_t no_triangle = 0xffffffffu;

  /// `look` is called again and again, and may end it by throwing.
  Surface_layer(const std::vector<Projected_point>& points,
                const std::vector<Triangle>& triangles,
                int width,
                int height,
                const std::function<void()>& look);

  int width() const { return width_; }
  int height() const { return height_; }
  std::uint32_t triangle(int x, int y) const { return triangles_[index(x, y)]; }

  /// zero where there is no triangle.
  float inverse_depth(int x, int y) const { return inverse_depths_[index(x, y)]; }

private:
  std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }

  void draw(std::uint32_t triangle, Projected_point a, Projected_point b, Projected_point c);

  int width_, height_;
  std::vector<float> inverse_depths_;
  std::vector<std::uint32_t> triangles_;
};

/// the weights of the corners of a triangle at the point of it that is seen at a place of the
/// picture.
std::array<float, 3>
corner_weights(const std::array<Projected_point, 3>& corners, float x, float y);

} // namespace htl_picture

#endif // HTL_PICTURE_SURFACE_LAYER_H
