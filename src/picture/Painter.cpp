// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace htl_picture {
namespace {

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

} // namespace

Painter::Painter(
    const Subject& subject, const Camera& camera, const Options& options, int width, int height)
    : subject_(subject)
    , options_(options)
    , camera_(camera)
    , width_(width)
    , height_(height)
    , points_(points_in_frame(camera_, subject.points))
    , projected_(project(camera_, points_))
    , normals_(points_, subject.triangles)
    , surface_(projected_, subject.triangles, samples * width, samples * height, options.look)
    , lines_(camera_,
             surface_,
             subject.lines,
             float(samples * options.line_width_px / 2.),
             options.look)
    , reach_of_edges_((std::max)(1, static_cast<int>(std::lround(height / 900.)))) {}

std::vector<Colour> Painter::paint() {
  const std::vector<float> open = find_openness();
  std::vector<Colour> pixels;
  pixels.reserve(open.size());
  for(int y = 0; y < height_; ++y) {
    options_.look();
    for(int x = 0; x < width_; ++x) {
      const int i = samples * x, j = samples * y;
      pixels.push_back(to_srgb(pixel(i, j, open[pixels.size()], edge_of_pixel(i, j))));
    }
  }
  return pixels;
}

Painter::Facing Painter::facing(int x, int y) {
  const std::uint32_t triangle = surface_.triangle(x, y);
  if(triangle == Surface_layer::no_triangle)
    return {};
  if(recent_.triangle != triangle) {
    recent_ = {triangle, normals_(triangle), {}};
    for(int i = 0; i < 3; ++i)
      recent_.corners[i] = projected_[subject_.triangles[triangle][i]];
  }
  const auto weights = corner_weights(recent_.corners, x + 0.5f, y + 0.5f);
  Vector_3 sum;
  for(int i = 0; i < 3; ++i)
    sum = sum + weights[i] * recent_.normals[i];
  const Vector_3 n = normalized(sum);
  const bool is_back = n.z < 0.f;
  return {is_back ? -1.f * n : n, is_back};
}

std::vector<float> Painter::find_openness() {
  Seen_surface seen = {width_, height_, {}, {}};
  for(int y = 0; y < height_; ++y) {
    options_.look();
    for(int x = 0; x < width_; ++x) {
      const int i = samples * x, j = samples * y;
      seen.normals.push_back(facing(i, j).normal);
      seen.points.push_back(
          seen.is_covered(seen.points.size())
              ? camera_.unproject({i + 0.5f, j + 0.5f, surface_.inverse_depth(i, j)})
              : Vector_3{});
    }
  }
  return openness(seen, 1.f / (samples * camera_.pixel_size_in_middle()), options_.look);
}

// The mean of the samples of a pixel, of which the first is given.
Vector_3 Painter::pixel(int x, int y, float open, float edge) {
  if(is_of_one_triangle(x, y))
    return sample(x, y, open, edge);
  Vector_3 sum;
  for(int j = y; j < y + samples; ++j)
    for(int i = x; i < x + samples; ++i)
      sum = sum + sample(i, j, open, edge);
  return (1.f / (samples * samples)) * sum;
}

// Whether the samples of a pixel show nothing but one triangle, or nothing at all.
bool Painter::is_of_one_triangle(int x, int y) const {
  for(int j = y; j < y + samples; ++j)
    for(int i = x; i < x + samples; ++i)
      if(surface_.triangle(i, j) != surface_.triangle(x, y) ||
         lines_.in_front(i, j).line != Line_layer::no_line ||
         lines_.behind(i, j).line != Line_layer::no_line)
        return false;
  return true;
}

Vector_3 Painter::sample(int x, int y, float open, float edge) {
  const Line_layer::Sample& front = lines_.in_front(x, y);
  if(front.line != Line_layer::no_line && !front.is_gap())
    return line_colour(front);

  const std::uint32_t triangle = surface_.triangle(x, y);
  if(triangle == Surface_layer::no_triangle)
    return to_linear(options_.background);
  const Colour& own = subject_.triangle_colours.empty() ? options_.surface_colour
                                                        : subject_.triangle_colours[triangle];
  const auto [normal, is_back] = facing(x, y);
  const bool is_inside = is_back && subject_.is_cut_open;
  const Vector_3 tinted =
      is_inside ? modulate(to_linear(own), {0.80f, 0.62f, 0.48f}) : to_linear(own);
  const Vector_3 surface = (1.f - 0.62f * edge) * shade_surface(tinted, normal, open);
  const Line_layer::Sample& behind = lines_.behind(x, y);
  if(behind.line == Line_layer::no_line || behind.is_gap())
    return surface;
  const auto opacity = static_cast<float>(options_.surface_opacity);
  return opacity * surface + (1.f - opacity) * line_colour(behind);
}

// How much the inverse of the depth of a triangle's plane changes along a way in the picture.
float Painter::slope(std::uint32_t triangle, int dx, int dy) const {
  const auto& [i, j, k] = subject_.triangles[triangle];
  const Projected_point &a = projected_[i], &b = projected_[j], &c = projected_[k];
  const double bx = double(b.x) - a.x, by = double(b.y) - a.y, cx = double(c.x) - a.x,
               cy = double(c.y) - a.y, whole = bx * cy - cx * by;
  if(whole == 0.)
    return 0.f;
  const double of_b = double(b.inverse_depth) - a.inverse_depth,
               of_c = double(c.inverse_depth) - a.inverse_depth;
  return float(((of_b * cy - of_c * by) * dx + (of_c * bx - of_b * cx) * dy) / whole);
}

// How far what is seen at two samples is apart in depth. The planes of triangles that share an edge
// meet between the samples, however steep they are: that is a crease, and no step.
float Painter::step_between(int x0, int y0, int x1, int y1) const {
  const std::uint32_t triangle0 = surface_.triangle(x0, y0), triangle1 = surface_.triangle(x1, y1);
  if(triangle0 == triangle1)
    return 0.f;
  const float between = surface_.inverse_depth(x0, y0) - surface_.inverse_depth(x1, y1);
  if(triangle0 == Surface_layer::no_triangle || triangle1 == Surface_layer::no_triangle)
    return std::abs(between);
  const float at0 = between + slope(triangle1, x1 - x0, y1 - y0),
              at1 = between + slope(triangle0, x1 - x0, y1 - y0);
  return at0 * at1 > 0.f ? (std::min)(std::abs(at0), std::abs(at1)) : 0.f;
}

// How much a sample is on the edge of what is nearer than what is beside it, 0 to 1. The inverse of
// the depth is linear on a plane: there it is the mean of those on both sides.
float Painter::edge_at(int x, int y) const {
  const float here = surface_.inverse_depth(x, y);
  if(!(here > 0.f))
    return 0.f;
  constexpr float least = 0.012f, clear = 0.035f; // steps, in the unit of the frame
  float step = 0.f;                               // of the inverse
  const auto look_along = [&](int dx, int dy) {
    const int x0 = x - dx, y0 = y - dy, x1 = x + dx, y1 = y + dy;
    if(x0 < 0 || y0 < 0 || x1 >= surface_.width() || y1 >= surface_.height())
      return;
    const float bend =
        std::abs(2.f * here - surface_.inverse_depth(x0, y0) - surface_.inverse_depth(x1, y1));
    if(bend > (std::max)(step, least * here * here))
      step = (std::max)(step, (std::min)(bend, (std::max)(step_between(x, y, x0, y0),
                                                          step_between(x, y, x1, y1))));
  };
  look_along(reach_of_edges_, 0);
  look_along(0, reach_of_edges_);
  return std::clamp((step / (here * here) - least) / (clear - least), 0.f, 1.f);
}

float Painter::edge_of_pixel(int x, int y) const {
  float sum = 0.f;
  for(int j = y; j < y + samples; ++j)
    for(int i = x; i < x + samples; ++i)
      sum += edge_at(i, j);
  return sum / (samples * samples);
}

Vector_3 Painter::line_colour(const Line_layer::Sample& sample) const {
  constexpr float border = 0.6f; // of half the width
  const Line& line = subject_.lines[sample.line];
  const float inside = line.is_outlined ? border : 1.f;
  return sample.across > inside ? to_linear({255, 255, 255})
                                : shade_line(to_linear(line.colour), sample.across / inside);
}

} // namespace htl_picture
