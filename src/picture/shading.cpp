// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "shading.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace htl_picture {
namespace {

constexpr float cosine_of_crease = 0.76f; // 40 degrees

std::array<float, 256> make_linear_table() {
  std::array<float, 256> table;
  for(int i = 0; i < 256; ++i) {
    const float s = i / 255.f;
    table[i] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
  }
  return table;
}

unsigned char to_srgb(float linear) {
  const float l = std::clamp(linear, 0.f, 1.f);
  const float s = l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.f / 2.4f) - 0.055f;
  return static_cast<unsigned char>(std::lround(255.f * s));
}

/// the share of a light that a surface receives, which fades out a little beyond the terminator.
float diffuse(Vector_3 normal, Vector_3 light) {
  constexpr float wrap = 0.25f;
  return (std::max)(0.f, (dot(normal, light) + wrap) / (1.f + wrap));
}

constexpr float reach = 0.16f; // how far occluders count, in units of the camera's frame
constexpr int number_of_directions = 20;
constexpr int tile = 4; // the pattern of samples repeats after so many pixels

using Offset = std::array<int, 2>; // in pixels

/// the points of a spiral in a disc, turned by an angle.
std::array<Offset, number_of_directions> spiral(float disc_radius, float turn) {
  std::array<Offset, number_of_directions> offsets;
  for(int i = 0; i < number_of_directions; ++i) {
    const float radius = disc_radius * std::sqrt((i + 0.5f) / number_of_directions);
    const float angle = 2.39996f * i + turn; // the golden angle
    offsets[i] = {int(std::lround(radius * std::cos(angle))),
                  int(std::lround(radius * std::sin(angle)))};
  }
  return offsets;
}

/// how much a point hides of the sky above another one.
float occlusion(Vector_3 from, Vector_3 normal, Vector_3 occluder) {
  const Vector_3 v = occluder - from;
  const float squared = dot(v, v), height = dot(v, normal);
  const float fading = 1.f - squared / (reach * reach);
  if(fading <= 0.f)
    return 0.f;
  constexpr float slack = 0.004f; // the surface does not hide itself
  return fading * (std::max)(0.f, height - slack) / std::sqrt(squared + 1e-8f);
}

/// calls `visit(x, y, number)` for each pixel at which there is a surface; `look` between rows.
template <typename Visit>
void for_each_covered(const Seen_surface& seen, const std::function<void()>& look, Visit visit) {
  for(int y = 0; y < seen.height; ++y) {
    look();
    for(int x = 0; x < seen.width; ++x)
      if(const std::size_t here = std::size_t(y) * seen.width + x; seen.is_covered(here))
        visit(x, y, here);
  }
}

/// the mean over a tile around each pixel, of the pixels that are on the same part of the surface.
std::vector<float> blur(const std::vector<float>& values,
                        const Seen_surface& seen,
                        const std::function<void()>& look) {
  std::vector<float> blurred(values.size(), 1.f);
  for_each_covered(seen, look, [&](int x, int y, std::size_t here) {
    float sum = 0.f, count = 0.f;
    const int first_x = (std::max)(0, x - tile / 2), last_x = (std::min)(seen.width, x + tile / 2);
    const int first_y = (std::max)(0, y - tile / 2), last_y = (std::min)(seen.height, y + tile / 2);
    for(int j = first_y; j < last_y; ++j)
      for(int i = first_x; i < last_x; ++i) {
        const std::size_t there = std::size_t(j) * seen.width + i;
        if(!seen.is_covered(there) ||
           std::abs(seen.points[there].z - seen.points[here].z) > 0.2f * reach)
          continue;
        sum += values[there];
        count += 1.f;
      }
    blurred[here] = count > 0.f ? sum / count : values[here];
  });
  return blurred;
}

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

Vector_3 to_linear(const Colour& srgb) {
  static const std::array<float, 256> table = make_linear_table();
  return {table[srgb[0]], table[srgb[1]], table[srgb[2]]};
}

Colour to_srgb(Vector_3 linear) {
  return {to_srgb(linear.x), to_srgb(linear.y), to_srgb(linear.z)};
}

Vector_3 shade_surface(Vector_3 colour, Vector_3 normal, float openness) {
  static const Vector_3 key = normalized({-0.5f, 0.6f, 0.75f});
  static const Vector_3 fill = normalized({0.85f, 0.05f, 0.5f});
  static const Vector_3 back = normalized({0.3f, 0.9f, -0.35f});
  static const Vector_3 highlight = normalized(key + Vector_3{0.f, 0.f, 1.f});

  const float sky = 0.5f + 0.5f * normal.y;
  const float lit = 0.25f + 0.75f * openness; // little of any light gets into a cavity
  const Vector_3 light =
      openness * (Vector_3{0.17f, 0.18f, 0.21f} + sky * Vector_3{0.15f, 0.16f, 0.18f}) +
      lit * (diffuse(normal, key) * Vector_3{0.62f, 0.60f, 0.57f} +
             diffuse(normal, fill) * Vector_3{0.19f, 0.20f, 0.23f} +
             diffuse(normal, back) * Vector_3{0.16f, 0.16f, 0.17f});
  const float gloss = 0.07f * std::pow((std::max)(0.f, dot(normal, highlight)), 30.f) * openness;
  // A darker rim sets one part of the surface off from another and from the background.
  const float facing = std::clamp(normal.z, 0.f, 1.f);
  const float rim = 0.7f + 0.3f * (1.f - (1.f - facing) * (1.f - facing) * (1.f - facing));
  return rim * modulate(colour, light) + Vector_3{gloss, gloss, gloss};
}

Vector_3 shade_line(Vector_3 colour, float across) {
  const float facing = std::sqrt((std::max)(0.f, 1.f - across * across));
  const float gloss = 0.12f * std::pow(facing, 16.f);
  return (0.35f + 0.65f * facing) * colour + Vector_3{gloss, gloss, gloss};
}

std::vector<float>
openness(const Seen_surface& seen, float pixels_per_unit, const std::function<void()>& look) {
  std::array<std::array<Offset, number_of_directions>, tile * tile> patterns;
  for(int i = 0; i < tile * tile; ++i)
    patterns[i] =
        spiral(reach * pixels_per_unit, 6.28319f * ((i * 7) % (tile * tile)) / (tile * tile));

  std::vector<float> open(seen.points.size(), 1.f);
  for_each_covered(seen, look, [&](int x, int y, std::size_t here) {
    float hidden = 0.f;
    for(const auto& [dx, dy] : patterns[(y % tile) * tile + x % tile]) {
      const int i = x + dx, j = y + dy;
      if(i < 0 || j < 0 || i >= seen.width || j >= seen.height)
        continue;
      const std::size_t there = std::size_t(j) * seen.width + i;
      if(seen.is_covered(there))
        hidden += occlusion(seen.points[here], seen.normals[here], seen.points[there]);
    }
    open[here] = std::clamp(1.f - 2.2f * hidden / number_of_directions, 0.f, 1.f);
  });
  return blur(open, seen, look);
}

} // namespace htl_picture
