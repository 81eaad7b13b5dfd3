// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "closed_tube.h"

#include "grid_surface.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// A point of the centre line with two unit vectors normal to the line and each other.
struct Ring
{
  Vector centre, tangent, normal, binormal;

  void set_normal(const Vector& v) {
    normal = unit(v - (v * tangent) * tangent);
    binormal = CGAL::cross_product(tangent, normal);
  }
};

/// some direction that is not along the tangent.
Vector away_from(const Vector& tangent) {
  return std::abs(tangent.z()) < 0.9 ? Vector(0, 0, 1) : Vector(1, 0, 0);
}

/// rings along the closed curve whose frames turn as little as possible: they are carried along it,
/// and the angle by which the last misses the first is shared among all.
std::vector<Ring> carry_frames(const Curve_by_length& curve, std::size_t count) {
  const double step = curve.length() / count;
  std::vector<Ring> rings(count + 1);
  for(std::size_t i = 0; i <= count; ++i) {
    const double s = step * (i % count);
    const double h = 1e-3 * curve.length();
    rings[i].centre = curve.point(s);
    rings[i].tangent = unit(curve.point(s + h < curve.length() ? s + h : s + h - curve.length()) -
                            curve.point(s > h ? s - h : s - h + curve.length()));
    rings[i].set_normal(i == 0 ? away_from(rings[0].tangent) : rings[i - 1].normal);
  }
  const double miss =
      std::atan2(rings[count].normal * rings[0].binormal, rings[count].normal * rings[0].normal);
  rings.pop_back();
  for(std::size_t i = 0; i < count; ++i) {
    const double angle = -miss * i / count;
    rings[i].set_normal(std::cos(angle) * rings[i].normal + std::sin(angle) * rings[i].binormal);
  }
  return rings;
}

} // namespace

Curve_by_length::Curve_by_length(std::function<Vector(double)> curve)
    : curve_(std::move(curve)) {
  for(int i = 1; i <= samples; ++i)
    length_[i] =
        length_[i - 1] + generators::length(curve_(parameter(i)) - curve_(parameter(i - 1)));
}

Vector Curve_by_length::point(double s) const {
  const auto after = std::upper_bound(length_.begin() + 1, length_.end() - 1, s);
  const auto i = static_cast<int>(after - length_.begin());
  const double part = (s - length_[i - 1]) / (length_[i] - length_[i - 1]);
  return curve_(parameter(i - 1 + part));
}

double Curve_by_length::parameter(double i) { return 2. * CGAL_PI * i / samples; }

Soup closed_tube(const Curve_by_length& curve, double radius, std::size_t faces) {
  const Grid_size size = grid_size(faces, curve.length() / (2. * CGAL_PI * radius));
  const std::vector<Ring> rings = carry_frames(curve, size.along);
  return grid_surface(size, [&](std::size_t i, std::size_t j) {
    const double v = 2. * CGAL_PI * j / size.around;
    const Ring& ring = rings[i];
    return ring.centre + radius * (std::cos(v) * ring.normal - std::sin(v) * ring.binormal);
  });
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
