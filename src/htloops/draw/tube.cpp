// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/tube.h"

#include "draw/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace htloops {
namespace {

constexpr std::uint32_t sides = 8;

Vector sum(const Vector& a, double factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

// Across a direction.
Vector across(const Vector& direction, const Vector& wanted) {
  const Vector aside = unit(sum(wanted, -dot(wanted, direction), direction));
  if(dot(aside, aside) > 0.5)
    return aside;
  const Vector least = std::abs(direction[0]) < 0.6 ? Vector{1., 0., 0.} : Vector{0., 1., 0.};
  return unit(sum(least, -dot(least, direction), direction));
}

// Points that follow each other at the same place are one.
std::vector<Vector> without_repetitions(const std::vector<Vector>& line, bool is_closed) {
  std::vector<Vector> points = line;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while(is_closed && points.size() > 1 && points.front() == points.back())
    points.pop_back();
  return points;
}

class Tube
{
public:
  Tube(const std::vector<Vector>& line, bool is_closed, double radius)
      : line_(without_repetitions(line, is_closed))
      , is_closed_(is_closed)
      , radius_(radius) {}

  Smooth_surface build() {
    if(line_.size() < 2)
      return {};
    Vector aside = across(direction(0), {0., 0., 1.});
    const Vector first = aside;
    for(std::size_t i = 0; i < line_.size(); ++i)
      add_ring(i, aside = across(direction(i), aside));
    for(std::size_t i = 0; i + 1 < line_.size(); ++i)
      join(i, i + 1, 0);
    if(is_closed_)
      join(line_.size() - 1, 0, turn(across(direction(0), aside), first));
    return std::move(tube_);
  }

private:
  // Of the line at a point, in the middle between what comes before and after.
  Vector direction(std::size_t i) const {
    const std::size_t n = line_.size();
    const std::size_t before = i > 0 ? i - 1 : is_closed_ ? n - 1 : 0;
    const std::size_t after = i + 1 < n ? i + 1 : is_closed_ ? 0 : i;
    const Vector to = unit(sum(line_[i], -1., line_[before]));
    const Vector from = unit(sum(line_[after], -1., line_[i]));
    const Vector both = unit(sum(to, 1., from));
    return dot(both, both) > 0.5 ? both : to;
  }

  void add_ring(std::size_t i, const Vector& aside) {
    const Vector other = cross(direction(i), aside);
    for(std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2. * pi * k / sides;
      const Vector normal = sum(sum({}, std::cos(angle), aside), std::sin(angle), other);
      tube_.normals.push_back(normal);
      tube_.points.push_back(sum(line_[i], radius_, normal));
    }
  }

  // By how many sides the last ring is turned against the first one.
  std::uint32_t turn(const Vector& last, const Vector& first) const {
    const double angle = std::atan2(dot(cross(direction(0), first), last), dot(first, last));
    return static_cast<std::uint32_t>(std::lround(angle / (2. * pi) * sides) + sides) % sides;
  }

  void join(std::size_t from, std::size_t to, std::uint32_t shift) {
    const auto corner = [](std::size_t ring, std::uint32_t k) {
      return static_cast<std::uint32_t>(ring * sides + k % sides);
    };
    for(std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = corner(from, k), b = corner(from, k + 1);
      const std::uint32_t c = corner(to, k + shift), d = corner(to, k + 1 + shift);
      tube_.triangles.push_back({a, b, c});
      tube_.triangles.push_back({b, d, c});
    }
  }

  const std::vector<Vector> line_;
  const bool is_closed_;
  const double radius_;
  Smooth_surface tube_;
};

} // namespace

Smooth_surface tube_around(const std::vector<Vector>& line, bool is_closed, double radius) {
  return Tube(line, is_closed, radius).build();
}

} // namespace htloops
