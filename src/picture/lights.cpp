// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "lights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace htl_picture {
namespace {

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

} // namespace

Vector_3 to_linear(const Colour& srgb) {
  static const std::array<float, 256> table = make_linear_table();
  return {table[srgb[0]], table[srgb[1]], table[srgb[2]]};
}

Colour to_srgb(Vector_3 linear) {
  return {to_srgb(linear.x), to_srgb(linear.y), to_srgb(linear.z)};
}

Vector_3 shade_surface(Vector_3 colour, Vector_3 normal, float openness) {
  static const Vector_3 key = normalized({-0.45f, 0.65f, 0.75f});
  static const Vector_3 fill = normalized({0.8f, -0.1f, 0.55f});
  static const Vector_3 highlight = normalized(key + Vector_3{0.f, 0.f, 1.f});

  const float sky = 0.5f + 0.5f * normal.y;
  const Vector_3 light =
      openness * (Vector_3{0.20f, 0.21f, 0.24f} + sky * Vector_3{0.13f, 0.14f, 0.16f}) +
      (0.35f + 0.65f * openness) * (diffuse(normal, key) * Vector_3{0.74f, 0.72f, 0.68f} +
                                    diffuse(normal, fill) * Vector_3{0.13f, 0.14f, 0.17f});
  const float gloss = 0.10f * std::pow((std::max)(0.f, dot(normal, highlight)), 30.f) * openness;
  // A darker rim sets one part of the surface off from another and from the background.
  const float facing = std::clamp(normal.z, 0.f, 1.f);
  const float rim = 0.55f + 0.45f * (1.f - (1.f - facing) * (1.f - facing) * (1.f - facing));
  return rim * modulate(colour, light) + Vector_3{gloss, gloss, gloss};
}

Vector_3 shade_line(Vector_3 colour, float across) {
  const float facing = std::sqrt((std::max)(0.f, 1.f - across * across));
  const float gloss = 0.12f * std::pow(facing, 16.f);
  return (0.35f + 0.65f * facing) * colour + Vector_3{gloss, gloss, gloss};
}

} // namespace htl_picture
