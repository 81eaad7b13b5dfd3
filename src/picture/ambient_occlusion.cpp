// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "ambient_occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace htl_picture {
namespace {

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

/// the mean over a tile around each pixel, of the pixels that are on the same part of the surface.
std::vector<float> blur(const std::vector<float>& values,
                        const Seen_surface& seen,
                        const std::function<void()>& look) {
  std::vector<float> blurred(values.size(), 1.f);
  for(int y = 0; y < seen.height; ++y) {
    look();
    for(int x = 0; x < seen.width; ++x) {
      const std::size_t here = std::size_t(y) * seen.width + x;
      if(!seen.is_covered(here))
        continue;
      float sum = 0.f, count = 0.f;
      const int first_x = (std::max)(0, x - tile / 2),
                last_x = (std::min)(seen.width, x + tile / 2);
      const int first_y = (std::max)(0, y - tile / 2),
                last_y = (std::min)(seen.height, y + tile / 2);
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
    }
  }
  return blurred;
}

} // namespace

std::vector<float>
openness(const Seen_surface& seen, float pixels_per_unit, const std::function<void()>& look) {
  std::array<std::array<Offset, number_of_directions>, tile * tile> patterns;
  for(int i = 0; i < tile * tile; ++i)
    patterns[i] =
        spiral(reach * pixels_per_unit, 6.28319f * ((i * 7) % (tile * tile)) / (tile * tile));

  std::vector<float> open(seen.points.size(), 1.f);
  for(int y = 0; y < seen.height; ++y) {
    look();
    for(int x = 0; x < seen.width; ++x) {
      const std::size_t here = std::size_t(y) * seen.width + x;
      if(!seen.is_covered(here))
        continue;
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
    }
  }
  return blur(open, seen, look);
}

} // namespace htl_picture
