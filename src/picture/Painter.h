// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_PAINTER_H
#define HTL_PICTURE_PAINTER_H

#include "Camera.h"
#include "layers.h"
#include "picture.h"
#include "shading.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htl_picture {

constexpr int samples = 2; // per pixel, in each direction

/// What is to be drawn.
struct Subject
{
  const std::vector<Point>& points;
  const std::vector<Triangle>& triangles;
  const std::vector<Colour>& triangle_colours; ///< none: all as the options say
  const std::vector<Line>& lines;
  bool is_cut_open; ///< the inner side of the surface has a tint of its own
};

/// Finds what is seen, and draws it without words. The camera is one of the samples.
class Painter
{
public:
  Painter(
      const Subject& subject, const Camera& camera, const Options& options, int width, int height);

  std::vector<Colour> paint();

  const Line_layer& lines() const { return lines_; }

private:
  /// The triangle at the last sample: the next is likely to show the same.
  struct Recent
  {
    std::uint32_t triangle = Surface_layer::no_triangle;
    std::array<Vector_3, 3> normals;
    std::array<Projected_point, 3> corners;
  };

  struct Facing
  {
    Vector_3 normal;      ///< turned to the eye; null if there is no surface
    bool is_back = false; ///< the inner side is seen
  };

  Facing facing(int x, int y);
  std::vector<float> find_openness();
  Vector_3 pixel(int x, int y, float open, float edge);
  bool is_of_one_triangle(int x, int y) const;
  Vector_3 sample(int x, int y, float open, float edge);
  float slope(std::uint32_t triangle, int dx, int dy) const;
  float step_between(int x0, int y0, int x1, int y1) const;
  float edge_at(int x, int y) const;
  float edge_of_pixel(int x, int y) const;
  Vector_3 line_colour(const Line_layer::Sample& sample) const;

  const Subject& subject_;
  const Options& options_;
  const Camera& camera_;
  int width_, height_; // in pixels
  std::vector<Vector_3> points_;
  std::vector<Projected_point> projected_;
  Corner_normals normals_;
  Surface_layer surface_;
  Line_layer lines_;
  Recent recent_;
  int reach_of_edges_; // in samples
};

} // namespace htl_picture

#endif // HTL_PICTURE_PAINTER_H
