// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "picture.h"

#include "Camera.h"
#include "Painter.h"
#include "Text_layer.h"
#include "annotations.h"
#include "cut_away.h"
#include "encode_png.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace htl_picture {
namespace {

using Sets_of_points = std::vector<const std::vector<Point>*>;

void check(const std::vector<Panel>& panels, const Options& options) {
  check_size(static_cast<std::size_t>(options.width), static_cast<std::size_t>(options.height));
  if(options.width < static_cast<int>(panels.size()))
    throw std::runtime_error("no picture: there is no pixel for each surface");
  for(const Panel& panel : panels)
    if(!panel.triangle_colours.empty() && panel.triangle_colours.size() != panel.triangles.size())
      throw std::runtime_error("no picture: there must be a colour for each triangle");
}

void add_points(const std::vector<Line>& lines, Sets_of_points& seen) {
  for(const Line& line : lines)
    seen.push_back(&line.points);
}

Camera camera_for(const Sets_of_points& seen,
                  const Options& options,
                  int width,
                  int height,
                  double part = Camera::usual_part) {
  return Camera(seen, options.view, options.up, samples * width, samples * height, part);
}

Camera camera_for(const std::vector<Panel>& panels, const Options& options, int width, int height) {
  Sets_of_points seen;
  for(const Panel& panel : panels) {
    seen.push_back(&panel.points);
    add_points(panel.lines, seen);
  }
  return camera_for(seen, options, width, height);
}

// Copies a smaller picture into one that is so wide.
void paste(const std::vector<Colour>& part,
           int part_width,
           int x,
           int y,
           int width,
           std::vector<Colour>& pixels) {
  for(std::size_t row = 0; row * std::size_t(part_width) < part.size(); ++row)
    std::copy_n(part.begin() + std::ptrdiff_t(row) * part_width, part_width,
                pixels.begin() + (std::ptrdiff_t(y) + std::ptrdiff_t(row)) * width + x);
}

constexpr Colour colour_of_frame = {90, 96, 106};

// A picture of all, with a ring around where something is.
struct Overview
{
  int width, height;
  std::vector<Colour> pixels;
};

Overview overview_of(const Panel& panel,
                     const std::vector<Point>& focus,
                     const Options& whole,
                     int width_of_whole) {
  Options options = whole;
  options.line_width_px = (std::max)(1.5, 0.4 * whole.line_width_px);
  Overview overview = {
      (std::max)(1, width_of_whole * 27 / 100), (std::max)(1, whole.height * 27 / 100), {}};
  const Camera camera = camera_for({panel}, options, overview.width, overview.height);
  const Subject subject = {panel.points, panel.triangles, panel.triangle_colours, panel.lines,
                           false};
  overview.pixels = Painter(subject, camera, options, overview.width, overview.height).paint();
  float left = 1e9f, right = 0.f, top = 1e9f, bottom = 0.f;
  for(const Point& point : focus) {
    const Projected_point p = camera.project(camera.in_frame(point));
    left = (std::min)(left, p.x / samples);
    right = (std::max)(right, p.x / samples);
    top = (std::min)(top, p.y / samples);
    bottom = (std::max)(bottom, p.y / samples);
  }
  Text_layer marks(overview.width, overview.height, 10.);
  const float size = (std::max)(right - left, bottom - top);
  marks.add_ring({(left + right) / 2.f,
                  (top + bottom) / 2.f,
                  (std::max)(0.05f * float(overview.width), 0.75f * size),
                  2.f,
                  {20, 22, 26}});
  marks.draw_on(overview.pixels);
  for(int x = 0; x < overview.width; ++x)
    overview.pixels[std::size_t(x)] = overview.pixels[overview.pixels.size() - 1 - std::size_t(x)] =
        colour_of_frame;
  for(int y = 0; y < overview.height; ++y)
    overview.pixels[std::size_t(y) * overview.width] =
        overview.pixels[std::size_t(y + 1) * overview.width - 1] = colour_of_frame;
  return overview;
}

// Puts it in the lower right corner of the picture of a panel, if that has room for it.
void paste_overview(const Panel& panel,
                    const std::vector<Point>& focus,
                    const Options& options,
                    int width,
                    std::vector<Colour>& pixels) {
  const Overview overview = overview_of(panel, focus, options, width);
  const int margin = options.height / 60;
  if(overview.width + margin < width && overview.height + margin < options.height)
    paste(overview.pixels, overview.width, width - overview.width - margin,
          options.height - overview.height - margin, width, pixels);
}

int width_of_panel(const std::vector<Panel>& panels, const Options& options) {
  return options.width / (std::max)(1, static_cast<int>(panels.size()));
}

// The pictures `paint(panel, is_first)`, each as wide as a panel is.
template <typename Paint>
std::string
encode_side_by_side(const std::vector<Panel>& panels, const Options& options, const Paint& paint) {
  std::vector<Colour> pixels(std::size_t(options.width) * std::size_t(options.height),
                             options.background);
  const int width = width_of_panel(panels, options);
  int x = 0;
  for(const Panel& panel : panels) {
    paste(paint(panel, x == 0), width, x, 0, options.width, pixels);
    x += width;
  }
  return encode_png(options.width, options.height, pixels, options.look);
}

} // namespace

void check_size(std::size_t width, std::size_t height) {
  constexpr std::size_t largest = 16384, millions = 50;
  if(width < 1 || height < 1 || width > largest || height > largest)
    throw std::runtime_error("no picture: its width and height must be from 1 to " +
                             std::to_string(largest) + " pixels");
  if(width * height > millions * 1000000)
    throw std::runtime_error("no picture: it would have more than " + std::to_string(millions) +
                             " million pixels");
}

std::string encode_picture(const std::vector<Panel>& panels, const Options& options) {
  check(panels, options);
  const int width = width_of_panel(panels, options);
  const Camera camera = camera_for(panels, options, width, options.height);
  return encode_side_by_side(panels, options, [&](const Panel& panel, bool is_first) {
    const Subject subject = {panel.points, panel.triangles, panel.triangle_colours, panel.lines,
                             false};
    Painter painter(subject, camera, options, width, options.height);
    std::vector<Colour> pixels = painter.paint();
    annotate({panel.lines, camera, painter.lines(), width, options.height}, options,
             {is_first, panel.caption}, pixels);
    return pixels;
  });
}

std::string encode_picture(const std::vector<Point>& points,
                           const std::vector<Triangle>& triangles,
                           const std::vector<Colour>& triangle_colours,
                           const std::vector<Line>& lines,
                           const Options& options) {
  return encode_picture({{points, triangles, triangle_colours, lines}}, options);
}

std::string
encode_closeup(const std::vector<Panel>& panels, const Focus& focus, const Options& options) {
  check(panels, options);
  const int width = width_of_panel(panels, options);
  constexpr double part = 0.55; // of the picture: what is around it is seen, too
  const Camera camera = camera_for({&focus.points}, options, width, options.height, part);
  float nearest = -1.f;
  for(const Point& point : focus.points)
    nearest = (std::max)(nearest, camera.in_frame(point).z);
  return encode_side_by_side(panels, options, [&](const Panel& panel, bool is_first) {
    const Rest rest = rest_below(nearest + float(focus.room), camera, panel.points, panel.triangles,
                                 panel.triangle_colours, panel.lines);
    const Subject subject = {rest.points, rest.triangles, rest.triangle_colours, rest.lines, true};
    Painter painter(subject, camera, options, width, options.height);
    std::vector<Colour> pixels = painter.paint();
    annotate({rest.lines, camera, painter.lines(), width, options.height}, options,
             {is_first, panel.caption}, pixels);
    if(is_first)
      paste_overview(panel, focus.points, options, width, pixels);
    return pixels;
  });
}

} // namespace htl_picture
