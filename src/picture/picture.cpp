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
#include "Corner_normals.h"
#include "Line_layer.h"
#include "Surface_layer.h"
#include "ambient_occlusion.h"
#include "encode_png.h"
#include "lights.h"

#include <stdexcept>

namespace htl_picture {
namespace {

constexpr int samples = 2; // per pixel, in each direction

/// What is to be drawn.
struct Scene
{
  const std::vector<Point>& points;
  const std::vector<Triangle>& triangles;
  const std::vector<Colour>& triangle_colours; ///< none: all as the options say
  const std::vector<Line>& lines;
};

Camera camera_for(const Scene& scene, const Options& options) {
  std::vector<const std::vector<Point>*> seen = {&scene.points};
  for(const Line& line : scene.lines)
    seen.push_back(&line.points);
  return Camera(seen, options.view, options.up, samples * options.width, samples * options.height);
}

std::vector<Vector_3> points_in_frame(const Camera& camera, const std::vector<Point>& points) {
  std::vector<Vector_3> in_frame;
  in_frame.reserve(points.size());
  for(const Point& point : points)
    in_frame.push_back(camera.in_frame(point));
  return in_frame;
}

std::vector<Projected_point> project(const Camera& camera, const std::vector<Vector_3>& points) {
  std::vector<Projected_point> projected;
  projected.reserve(points.size());
  for(const Vector_3& point : points)
    projected.push_back(camera.project(point));
  return projected;
}

class Painter
{
public:
  Painter(const Scene& scene, const Options& options)
      : scene_(scene)
      , options_(options)
      , camera_(camera_for(scene, options))
      , points_(points_in_frame(camera_, scene.points))
      , projected_(project(camera_, points_))
      , normals_(points_, scene.triangles)
      , surface_(projected_, scene.triangles, samples * options.width, samples * options.height)
      , lines_(camera_, surface_, scene.lines, float(samples * options.line_width_px / 2.)) {}

  std::vector<Colour> paint() {
    const std::vector<float> open = find_openness();
    std::vector<Colour> pixels;
    pixels.reserve(open.size());
    for(int y = 0; y < options_.height; ++y)
      for(int x = 0; x < options_.width; ++x)
        pixels.push_back(to_srgb(pixel(samples * x, samples * y, open[pixels.size()])));
    return pixels;
  }

private:
  /// The triangle at the last sample: the next is likely to show the same.
  struct Recent
  {
    std::uint32_t triangle = Surface_layer::no_triangle;
    std::array<Vector_3, 3> normals;
    std::array<Projected_point, 3> corners;
  };

  void recall(std::uint32_t triangle) {
    if(recent_.triangle == triangle)
      return;
    recent_.triangle = triangle;
    recent_.normals = normals_(triangle);
    for(int i = 0; i < 3; ++i)
      recent_.corners[i] = projected_[scene_.triangles[triangle][i]];
  }

  /// the normal of the surface seen at a sample, turned to the eye; null if there is no surface.
  Vector_3 normal(int x, int y) {
    const std::uint32_t triangle = surface_.triangle(x, y);
    if(triangle == Surface_layer::no_triangle)
      return {};
    recall(triangle);
    const auto weights = corner_weights(recent_.corners, x + 0.5f, y + 0.5f);
    Vector_3 sum;
    for(int i = 0; i < 3; ++i)
      sum = sum + weights[i] * recent_.normals[i];
    const Vector_3 n = normalized(sum);
    return n.z < 0.f ? -1.f * n : n;
  }

  std::vector<float> find_openness() {
    Seen_surface seen = {options_.width, options_.height, {}, {}};
    for(int y = 0; y < options_.height; ++y)
      for(int x = 0; x < options_.width; ++x) {
        const int i = samples * x, j = samples * y;
        seen.normals.push_back(normal(i, j));
        seen.points.push_back(
            seen.is_covered(seen.points.size())
                ? camera_.unproject({i + 0.5f, j + 0.5f, surface_.inverse_depth(i, j)})
                : Vector_3{});
      }
    return openness(seen, 1.f / (samples * camera_.pixel_size_in_middle()));
  }

  /// the mean of the samples of a pixel, of which the first is given.
  Vector_3 pixel(int x, int y, float open) {
    if(is_of_one_triangle(x, y))
      return sample(x, y, open);
    Vector_3 sum;
    for(int j = y; j < y + samples; ++j)
      for(int i = x; i < x + samples; ++i)
        sum = sum + sample(i, j, open);
    return (1.f / (samples * samples)) * sum;
  }

  /// whether the samples of a pixel show nothing but one triangle, or nothing at all.
  bool is_of_one_triangle(int x, int y) const {
    for(int j = y; j < y + samples; ++j)
      for(int i = x; i < x + samples; ++i)
        if(surface_.triangle(i, j) != surface_.triangle(x, y) ||
           lines_.in_front(i, j).line != Line_layer::no_line ||
           lines_.behind(i, j).line != Line_layer::no_line)
          return false;
    return true;
  }

  Vector_3 sample(int x, int y, float open) {
    const Line_layer::Sample& front = lines_.in_front(x, y);
    if(front.line != Line_layer::no_line)
      return line_colour(front);

    const std::uint32_t triangle = surface_.triangle(x, y);
    if(triangle == Surface_layer::no_triangle)
      return to_linear(options_.background);
    const Colour& own = scene_.triangle_colours.empty() ? options_.surface_colour
                                                        : scene_.triangle_colours[triangle];
    const Vector_3 surface = shade_surface(to_linear(own), normal(x, y), open);
    const Line_layer::Sample& behind = lines_.behind(x, y);
    if(behind.line == Line_layer::no_line)
      return surface;
    const auto opacity = static_cast<float>(options_.surface_opacity);
    return opacity * surface + (1.f - opacity) * line_colour(behind);
  }

  Vector_3 line_colour(const Line_layer::Sample& sample) const {
    return shade_line(to_linear(scene_.lines[sample.line].colour), sample.across);
  }

  const Scene& scene_;
  const Options& options_;
  Camera camera_;
  std::vector<Vector_3> points_;
  std::vector<Projected_point> projected_;
  Corner_normals normals_;
  Surface_layer surface_;
  Line_layer lines_;
  Recent recent_;
};

std::vector<Colour> paint(const Scene& scene, const Options& options) {
  constexpr int largest = 16384;
  if(options.width < 1 || options.height < 1 || options.width > largest || options.height > largest)
    throw std::runtime_error("no picture: its width and height must be from 1 to " +
                             std::to_string(largest) + " pixels");
  if(!scene.triangle_colours.empty() && scene.triangle_colours.size() != scene.triangles.size())
    throw std::runtime_error("no picture: there must be a colour for each triangle");
  return Painter(scene, options).paint();
}

} // namespace

std::string encode_picture(const std::vector<Point>& points,
                           const std::vector<Triangle>& triangles,
                           const std::vector<Colour>& triangle_colours,
                           const std::vector<Line>& lines,
                           const Options& options) {
  return encode_png(options.width, options.height,
                    paint({points, triangles, triangle_colours, lines}, options));
}

std::string encode_picture(const std::vector<Point>& points,
                           const std::vector<Triangle>& triangles,
                           const std::vector<Line>& lines,
                           const Options& options) {
  return encode_picture(points, triangles, {}, lines, options);
}

} // namespace htl_picture
