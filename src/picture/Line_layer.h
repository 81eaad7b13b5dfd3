// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_LINE_LAYER_H
#define HTL_PICTURE_LINE_LAYER_H

#include "Camera.h"
#include "Surface_layer.h"
#include "picture.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace htl_picture {

/// The lines at each sample of a picture: the nearest of those in front of the surface and the
/// nearest of those behind it.
class Line_layer
{
public:
  static constexpr std::uint32_t no_line = 0xffffffffu;

  /// What is seen of a line at a sample.
  struct Sample
  {
    float inverse_depth = 0.f;
    std::uint32_t line = no_line;
    float across = 0.f; ///< the distance from the middle of the line, in units of half its width
  };

  /// draws lines that are `radius` samples wide to each side.
  Line_layer(const Camera& camera,
             const Surface_layer& surface,
             const std::vector<Line>& lines,
             float radius);

  const Sample& in_front(int x, int y) const { return in_front_[index(x, y)]; }
  const Sample& behind(int x, int y) const { return behind_[index(x, y)]; }

private:
  std::size_t index(int x, int y) const { return std::size_t(y) * surface_.width() + x; }
  void draw_line(std::uint32_t line, const Line& points);
  void draw_segment(std::uint32_t line, Projected_point a, Projected_point b);
  void draw_sample(std::uint32_t line, int x, int y, float inverse_depth, float distance);

  const Camera& camera_;
  const Surface_layer& surface_;
  float radius_;
  std::vector<Sample> in_front_, behind_;
};

} // namespace htl_picture

#endif // HTL_PICTURE_LINE_LAYER_H
