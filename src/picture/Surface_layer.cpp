// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Surface_layer.h"

#include <algorithm>
#include <cmath>

namespace htl_picture {
namespace {

/// twice the signed area of the triangle with corners a, b and (x, y): with double precision it has
/// the right sign, so that triangles leave no gap along their common edge.
double signed_area(Projected_point a, Projected_point b, double x, double y) {
  return (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
}

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

} // namespace htl_picture
