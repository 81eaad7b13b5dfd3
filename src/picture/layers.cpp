// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "layers.h"

#include <algorithm>
#include <cmath>

namespace htl_picture {
namespace {

/// twice the signed area of the triangle with corners a, b and (x, y): with double precision it has
/// the right sign, so that triangles leave no gap along their common edge.
double signed_area(Projected_point a, Projected_point b, double x, double y) {
  return (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
}

constexpr float rim = 1.55f; // beside a line, where others make room, in units of half its width

} // namespace

Surface_layer::Surface_layer(const std::vector<Projected_point>& points,
                             const std::vector<Triangle>& triangles,
                             int width,
                             int height,
                             const std::function<void()>& look)
    : width_(width)
    , height_(height)
    , inverse_depths_(std::size_t(width) * height, 0.f)
    , triangles_(std::size_t(width) * height, no_triangle) {
  for(std::size_t t = 0; t < triangles.size(); ++t) {
    constexpr std::size_t triangles_between_looks = 64; // each may cover the whole picture
    if(t % triangles_between_looks == 0)
      look();
    const auto& [a, b, c] = triangles[t];
    draw(static_cast<std::uint32_t>(t), points[a], points[b], points[c]);
  }
}

void Surface_layer::draw(std::uint32_t triangle,
                         Projected_point a,
                         Projected_point b,
                         Projected_point c) {
  // Samples are at the centres of the pixels.
  const int first_x = (std::max)(0, int(std::ceil((std::min)({a.x, b.x, c.x}) - 0.5f)));
  const int last_x = (std::min)(width_ - 1, int(std::floor((std::max)({a.x, b.x, c.x}) - 0.5f)));
  const int first_y = (std::max)(0, int(std::ceil((std::min)({a.y, b.y, c.y}) - 0.5f)));
  const int last_y = (std::min)(height_ - 1, int(std::floor((std::max)({a.y, b.y, c.y}) - 0.5f)));
  if(first_x > last_x || first_y > last_y)
    return;
  const double area = signed_area(a, b, c.x, c.y);
  if(area == 0.)
    return;
  if(area < 0.)
    std::swap(b, c);

  const float nearest = (std::max)({a.inverse_depth, b.inverse_depth, c.inverse_depth});
  for(int y = first_y; y <= last_y; ++y)
    for(int x = first_x; x <= last_x; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double of_a = signed_area(b, c, px, py), of_b = signed_area(c, a, px, py),
                   of_c = signed_area(a, b, px, py);
      if(of_a < 0. || of_b < 0. || of_c < 0.)
        continue;
      const auto inverse_depth = static_cast<float>(
          (of_a * a.inverse_depth + of_b * b.inverse_depth + of_c * c.inverse_depth) /
          std::abs(area));
      const std::size_t i = index(x, y);
      if(inverse_depth > inverse_depths_[i]) {
        inverse_depths_[i] = (std::min)(inverse_depth, nearest); // however thin the triangle
        triangles_[i] = triangle;
      }
    }
}

std::array<float, 3>
corner_weights(const std::array<Projected_point, 3>& corners, float x, float y) {
  std::array<float, 3> weights;
  float sum = 0.f;
  for(int i = 0; i < 3; ++i) {
    const double area = signed_area(corners[(i + 1) % 3], corners[(i + 2) % 3], x, y);
    weights[i] = static_cast<float>(std::abs(area)) * corners[i].inverse_depth;
    sum += weights[i];
  }
  for(float& weight : weights)
    weight = sum > 0.f ? weight / sum : 1.f / 3.f;
  return weights;
}

Line_layer::Line_layer(const Camera& camera,
                       const Surface_layer& surface,
                       const std::vector<Line>& lines,
                       float radius,
                       const std::function<void()>& look)
    : camera_(camera)
    , surface_(surface)
    , radius_(radius)
    , in_front_(surface.width(), surface.height())
    , behind_(surface.width(), surface.height()) {
  for(std::size_t i = 0; i < lines.size(); ++i) {
    look();
    draw_line(static_cast<std::uint32_t>(i), lines[i]);
  }
}

Line_layer::Place Line_layer::place_on(const Line& line, std::size_t point) const {
  const Projected_point p = camera_.project(camera_.in_frame(line.points[point]));
  const float radius = line.radii.empty() ? static_cast<float>(line.width) * radius_
                                          : camera_.in_frame(line.radii[point]) /
                                                camera_.pixel_size(p.inverse_depth);
  return {p, (std::max)(radius, 0.5f)};
}

void Line_layer::draw_line(std::uint32_t number, const Line& line) {
  if(line.points.empty())
    return;
  // A line on a surface that is seen at a low angle is half below it: lift it by more than its
  // thickness. One that is as thick as what is around it touches the surface from inside.
  const float lift = line.radii.empty() ? 2.5f : -0.25f;
  Place first = place_on(line, 0);
  Place last = first;
  for(std::size_t i = 1; i < line.points.size(); ++i) {
    const Place next = place_on(line, i);
    // A loop has far more points than samples where triangles are tiny.
    if(std::hypot(next.x - last.x, next.y - last.y) < 0.7f)
      continue;
    draw_segment(number, last, next, lift);
    last = next;
  }
  const bool is_point = last.x == first.x && last.y == first.y;
  first.is_ball = last.is_ball = line.points.size() == 1;
  if(line.closed || is_point)
    draw_segment(number, last, first, lift);
}

void Line_layer::draw_segment(std::uint32_t line, Place a, Place b, float lift) {
  const float widest = rim * (std::max)(a.radius, b.radius);
  const int first_y = (std::max)(0, int((std::min)(a.y, b.y) - widest));
  const int last_y = (std::min)(surface_.height() - 1, int((std::max)(a.y, b.y) + widest));
  const float dx = b.x - a.x, dy = b.y - a.y, squared_length = dx * dx + dy * dy;
  for(int y = first_y; y <= last_y; ++y) {
    // The part of the segment that is near this row of samples.
    const float below = y - a.y - widest, above = y + 1.f - a.y + widest;
    const bool is_steep = std::abs(dy) > widest;
    const float s = is_steep ? std::clamp(below / dy, 0.f, 1.f) : 0.f,
                e = is_steep ? std::clamp(above / dy, 0.f, 1.f) : 1.f;
    const float left = a.x + (std::min)(s * dx, e * dx), right = a.x + (std::max)(s * dx, e * dx);
    const int first_x = (std::max)(0, int(left - widest) - 1),
              last_x = (std::min)(surface_.width() - 1, int(right + widest) + 1);
    for(int x = first_x; x <= last_x; ++x) {
      const float px = x + 0.5f - a.x, py = y + 0.5f - a.y;
      const float t =
          squared_length > 0.f ? std::clamp((px * dx + py * dy) / squared_length, 0.f, 1.f) : 0.f;
      const float squared_distance = (px - t * dx) * (px - t * dx) + (py - t * dy) * (py - t * dy);
      const float radius = a.radius + t * (b.radius - a.radius);
      if(squared_distance <= rim * rim * radius * radius)
        draw_sample(line, x, y,
                    {{0.f, 0.f, a.inverse_depth + t * (b.inverse_depth - a.inverse_depth)},
                     radius,
                     a.is_ball},
                    std::sqrt(squared_distance), lift);
    }
  }
}

void Line_layer::draw_sample(
    std::uint32_t line, int x, int y, Place middle, float distance, float lift) {
  // The tube is as thick as it is wide.
  const float depth = 1.f / middle.inverse_depth;
  const float radius = middle.radius * camera_.pixel_size(middle.inverse_depth);
  const float across = distance / middle.radius;
  const float front = depth - radius * std::sqrt((std::max)(0.f, 1.f - across * across));
  const float surface = surface_.inverse_depth(x, y);
  const bool is_in_front = (front - lift * radius) * surface < 1.f;

  Sample& sample = (is_in_front ? in_front_ : behind_).made_at(x, y);
  if(across > 1.f && middle.is_ball)
    return;
  if(across > 1.f) { // what is nearer than others leaves a gap beside it
    const float nearest = depth - radius;
    if(nearest * sample.inverse_depth_of_rim < 1.f) {
      sample.inverse_depth_of_rim = 1.f / nearest;
      sample.line_of_rim = line;
    }
    return;
  }
  // Where segments of a line join, the middle of one covers the rim of the other's round end.
  const bool is_joint =
      sample.line == line && std::abs(front * sample.inverse_depth - 1.f) < 2.f * radius / front;
  // Of lines that cross on the surface, the first is on top.
  const bool is_nearer = sample.line == no_line || sample.line == line
                             ? front * sample.inverse_depth < 1.f
                             : front < 1.f / sample.inverse_depth - radius;
  if(is_joint ? across < sample.across : is_nearer) {
    sample.inverse_depth = 1.f / front;
    sample.line = line;
    sample.across = across;
    sample.radius = middle.is_ball ? 0.f : radius;
  }
}

} // namespace htl_picture
