// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_PICTURE_H
#define HTL_PICTURE_PICTURE_H

#include "scene/scene.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// \file picture.h
/// Pictures of triangle meshes with lines on them, drawn in software.

namespace htl_picture {

using htl_scene::Colour;
using htl_scene::Point;
using htl_scene::Triangle;

/// A polyline, drawn as a tube; one of a single point as a ball.
struct Line
{
  std::vector<Point> points;
  Colour colour;
  bool closed;
  std::string label = {};   ///< written beside it where there is room; none if empty
  bool is_outlined = false; ///< with a white border, which sets it off from dark surfaces
  double width = 1.;        ///< as a multiple of that of all lines
  /// by point, how thick the tube is in the unit of the points, near and far; empty for a width in
  /// pixels.
  std::vector<double> radii = {};
};

/// What lines of a colour are.
struct Legend_entry
{
  Colour colour;
  std::string text;
};

/// How a picture is taken. The mesh always fills the picture.
struct Options
{
  int width = 1600;             ///< in pixels
  int height = 1200;            ///< in pixels
  Point view = {0.6, -1., 0.5}; ///< the direction from the mesh to the eye
  Point up = {0., 0., 1.};      ///< the direction that is upright in the picture
  double line_width_px = 5.;    ///< the same near and far
  double surface_opacity = 0.5; ///< 1 hides the lines behind the surface, 0 draws them like others
  Colour surface_colour = {204, 212, 222};
  Colour background = {255, 255, 255};
  std::vector<Legend_entry> legend = {}; ///< in a corner; none if empty
  bool has_scale_bar = false;            ///< how long a round number is in the middle
  std::string unit = {};                 ///< of that, as it is written; empty if it is not known
  bool has_rings = false;                ///< around closed lines that are too small to be found
  /// is called again and again while the picture is drawn, and may end that by throwing.
  std::function<void()> look = [] {};
};

/// A surface with lines; of several each has its part of the picture, side by side, as one camera
/// sees them.
struct Panel
{
  const std::vector<Point>& points;
  const std::vector<Triangle>& triangles;
  const std::vector<Colour>& triangle_colours; ///< of all triangles, or none
  const std::vector<Line>& lines;
  std::string caption = {}; ///< below it; none if empty
};

/// whether labels and legends are written: the build found a font.
bool has_font();

/// throws `std::runtime_error` unless pictures have such a size: of 50 million pixels at most, each
/// of which takes some 65 bytes.
void check_size(std::size_t width, std::size_t height);

/// the content of a PNG file. Throws `std::runtime_error` if the size is not one of a picture, or a
/// coordinate is not finite.
std::string encode_picture(const std::vector<Panel>& panels, const Options& options = Options());

/// of one surface.
std::string encode_picture(const std::vector<Point>& points,
                           const std::vector<Triangle>& triangles,
                           const std::vector<Colour>& triangle_colours,
                           const std::vector<Line>& lines,
                           const Options& options = Options());

/// What is drawn large.
struct Focus
{
  std::vector<Point> points;
  double room = 0.12; ///< in front of these, as a part of how far they reach
};

/// of what is around some points. What is nearer to the eye is cut away, and a small picture in a
/// corner tells where on the first surface they are.
std::string encode_closeup(const std::vector<Panel>& panels,
                           const Focus& focus,
                           const Options& options = Options());

} // namespace htl_picture

#endif // HTL_PICTURE_PICTURE_H
