// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CLOSED_CURVES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CLOSED_CURVES_H

#include "Field.h"
#include "functions.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {

/// A closed curve, by arc length.
class Curve_by_length
{
public:
  /// a curve as a function on [0, 2 pi].
  explicit Curve_by_length(std::function<Vector(double)> curve)
      : curve_(std::move(curve)) {
    for(int i = 1; i <= samples; ++i)
      length_[i] = length_[i - 1] + generators::length(sample(i) - sample(i - 1));
  }

  double length() const { return length_.back(); }

  Vector point(double s) const {
    const auto after = std::upper_bound(length_.begin() + 1, length_.end() - 1, s);
    const auto i = static_cast<int>(after - length_.begin());
    const double part = (s - length_[i - 1]) / (length_[i] - length_[i - 1]);
    return sample(i - 1 + part);
  }

private:
  static constexpr int samples = 10000;

  Vector sample(double i) const { return curve_(2. * CGAL_PI * i / samples); }

  std::function<Vector(double)> curve_;
  std::vector<double> length_ = std::vector<double>(samples + 1, 0.);
};

/// Curves on a torus that go around it p times the long way and q times the short way, as functions
/// on [0, 2 pi]. Those that are moved the short way by different angles are parallel.
class Torus_knot
{
public:
  Torus_knot(std::size_t p, std::size_t q)
      : p_(static_cast<double>(p))
      , q_(static_cast<double>(q)) {
    if(p == 0 || q == 0 || std::gcd(p, q) != 1)
      throw std::invalid_argument(
          "a torus knot needs two positive numbers without a common divisor, not " +
          std::to_string(p) + " and " + std::to_string(q));
  }

  Vector point(double t, double moved) const {
    const double u = p_ * t, v = q_ * t + moved;
    const double r = 1. + radius * cosine(v);
    return Vector(r * cosine(u), r * sine(u), radius * sine(v));
  }

  /// the angle between the places where the curve crosses a short circle.
  double period() const { return 2. * CGAL_PI / p_; }

  /// the least distance, along the torus, of two curves of which one is moved by an angle.
  double distance_along_torus(double moved) const {
    return radius * moved * inner_radius / hypotenuse(inner_radius, radius * q_ / p_);
  }

  /// a lower bound for the distance in space of such curves, and of the parts of one of them.
  double distance(double moved) const {
    // An arc is at most pi / 2 times as long as its chord.
    return (std::min)({2. / CGAL_PI * distance_along_torus(moved), radius, inner_radius});
  }

  double least_speed() const { return hypotenuse(p_ * inner_radius, q_ * radius); }

  /// the number of points at equal distances along a curve of which the chords are closer to the
  /// curve than `error`.
  std::size_t least_samples(double error) const {
    const double outer_radius = 1. + radius;
    const double most_length = 2. * CGAL_PI * hypotenuse(p_ * outer_radius, q_ * radius);
    const double acceleration = p_ * p_ * outer_radius + (q_ + 2. * p_) * q_ * radius;
    return static_cast<std::size_t>(
        std::ceil(most_length / least_speed() * std::sqrt(acceleration / (8. * error))));
  }

private:
  static constexpr double radius = 0.4, inner_radius = 1. - radius;

  double p_, q_;
};

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CLOSED_CURVES_H
