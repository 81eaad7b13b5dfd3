// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_SHADING_H
#define HTL_PICTURE_SHADING_H

#include "Camera.h"
#include "picture.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace htl_picture {

/// The normals with which triangles are shaded: at each corner the mean of those of the triangles
/// around it that make a small angle with the triangle itself, so that creases stay sharp.
class Corner_normals
{
public:
  Corner_normals(const std::vector<Vector_3>& points, const std::vector<Triangle>& triangles);

  std::array<Vector_3, 3> operator()(std::uint32_t triangle) const;

private:
  const std::vector<Triangle>& triangles_;
  std::vector<Vector_3> normals_; ///< of the triangles, as long as twice their areas
  std::vector<std::uint32_t> first_at_, at_vertex_; ///< the triangles at each vertex
};

// Light adds up in linear space; pictures store sRGB.
Vector_3 to_linear(const Colour& srgb);
Colour to_srgb(Vector_3 linear);

/// the light that a surface reflects to the eye, in a camera's frame: a key light from the upper
/// left, a fill light from the right, one from above and behind, and the sky. `openness` in [0, 1]
/// is the share of the sky that is not covered.
Vector_3 shade_surface(Vector_3 colour, Vector_3 normal, float openness);

/// the same for a line, seen at a distance `across` in [0, 1] from its middle.
Vector_3 shade_line(Vector_3 colour, float across);

/// A surface as seen at the pixels of a picture, in the camera's frame.
struct Seen_surface
{
  int width, height;
  std::vector<Vector_3> points;
  std::vector<Vector_3> normals; ///< null where there is no surface

  bool is_covered(std::size_t pixel) const { return dot(normals[pixel], normals[pixel]) > 0.f; }
};

/// for each pixel the share, in [0, 1], of the sky above the surface that the surface around it
/// leaves free, estimated from what is seen. `pixels_per_unit` is the scale of the picture; `look`
/// is called between rows.
std::vector<float>
openness(const Seen_surface& seen, float pixels_per_unit, const std::function<void()>& look);

} // namespace htl_picture

#endif // HTL_PICTURE_SHADING_H
