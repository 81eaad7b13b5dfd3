// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Corner_normals.h"

#include <numeric>

namespace htl_picture {
namespace {

constexpr float cosine_of_crease = 0.76f; // 40 degrees

} // namespace

Corner_normals::Corner_normals(const std::vector<Vector_3>& points,
                               const std::vector<Triangle>& triangles)
    : triangles_(triangles)
    , first_at_(points.size() + 2, 0)
    , at_vertex_(3 * triangles.size()) {
  normals_.reserve(triangles.size());
  for(const auto& [a, b, c] : triangles)
    normals_.push_back(cross(points[b] - points[a], points[c] - points[a]));

  // Counting sort; the offset by two leaves the starts at their place after the second loop.
  for(const Triangle& triangle : triangles)
    for(std::uint32_t v : triangle)
      ++first_at_[v + 2];
  std::partial_sum(first_at_.begin(), first_at_.end(), first_at_.begin());
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(std::uint32_t v : triangles[t])
      at_vertex_[first_at_[v + 1]++] = static_cast<std::uint32_t>(t);
}

std::array<Vector_3, 3> Corner_normals::operator()(std::uint32_t triangle) const {
  std::array<Vector_3, 3> at_corners;
  const Vector_3 own = normalized(normals_[triangle]);
  for(int i = 0; i < 3; ++i) {
    const std::uint32_t v = triangles_[triangle][i];
    Vector_3 sum;
    for(std::uint32_t j = first_at_[v]; j < first_at_[v + 1]; ++j) {
      const Vector_3 other = normals_[at_vertex_[j]];
      const float projection = dot(own, other);
      if(projection > 0.f &&
         projection * projection > cosine_of_crease * cosine_of_crease * dot(other, other))
        sum = sum + other;
    }
    const Vector_3 mean = normalized(sum);
    at_corners[i] = dot(mean, mean) > 0.f ? mean : own;
  }
  return at_corners;
}

} // namespace htl_picture
