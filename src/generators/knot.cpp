// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "grid_surface.h"
#include "kinds.h"
#include "request_checks.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

constexpr double tube_radius = 0.45;

Vector trefoil(double t) {
  return Vector(std::sin(t) + 2. * std::sin(2. * t), std::cos(t) - 2. * std::cos(2. * t),
                -std::sin(3. * t));
}

/// The trefoil, by arc length.
class Trefoil_by_length
{
public:
  Trefoil_by_length() {
    for(int i = 1; i <= samples; ++i)
      length_[i] =
          length_[i - 1] + generators::length(trefoil(parameter(i)) - trefoil(parameter(i - 1)));
  }

  double length() const { return length_.back(); }

  Vector point(double s) const {
    const auto after = std::upper_bound(length_.begin() + 1, length_.end() - 1, s);
    const auto i = static_cast<int>(after - length_.begin());
    const double part = (s - length_[i - 1]) / (length_[i] - length_[i - 1]);
    return trefoil(parameter(i - 1 + part));
  }

private:
  static constexpr int samples = 10000;
  static double parameter(double i) { return 2. * CGAL_PI * i / samples; }
  std::vector<double> length_ = std::vector<double>(samples + 1, 0.);
};

Vector unit(const Vector& v) { return v / length(v); }

/// A point of the centre line with two unit vectors normal to the line and each other.
struct Ring
{
  Vector centre, tangent, normal, binormal;

  void set_normal(const Vector& v) {
    normal = unit(v - (v * tangent) * tangent);
    binormal = CGAL::cross_product(tangent, normal);
  }
};

/// rings along the closed curve whose frames turn as little as possible: they are carried along it,
/// and the angle by which the last misses the first is shared among all.
std::vector<Ring> carry_frames(const Trefoil_by_length& curve, std::size_t count) {
  const double step = curve.length() / count;
  std::vector<Ring> rings(count + 1);
  for(std::size_t i = 0; i <= count; ++i) {
    const double s = step * (i % count);
    const double h = 1e-3 * curve.length();
    rings[i].centre = curve.point(s);
    rings[i].tangent = unit(curve.point(s + h < curve.length() ? s + h : s + h - curve.length()) -
                            curve.point(s > h ? s - h : s - h + curve.length()));
    rings[i].set_normal(i == 0 ? Vector(0, 0, 1) : rings[i - 1].normal);
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

Soup make_knot(const Request& request) {
  require_genus(request, "knot", 1);
  require_faces(request, "knot", 150);

  const Trefoil_by_length curve;
  const Grid_size size = grid_size(request.faces, curve.length() / (2. * CGAL_PI * tube_radius));
  const std::vector<Ring> rings = carry_frames(curve, size.along);
  return grid_surface(size, [&](std::size_t i, std::size_t j) {
    const double v = 2. * CGAL_PI * j / size.around;
    const Ring& ring = rings[i];
    return ring.centre + tube_radius * (std::cos(v) * ring.normal - std::sin(v) * ring.binormal);
  });
}

} // namespace

const Kind knot_kind = {"knot", "a tube around a trefoil knot; genus 1, from 150 faces", make_knot};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
