// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_AMBIENT_OCCLUSION_H
#define HTL_PICTURE_AMBIENT_OCCLUSION_H

#include "Camera.h"
#include "Surface_layer.h"
#include "Vector_3.h"

#include <functional>
#include <vector>

namespace htl_picture {

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

#endif // HTL_PICTURE_AMBIENT_OCCLUSION_H
