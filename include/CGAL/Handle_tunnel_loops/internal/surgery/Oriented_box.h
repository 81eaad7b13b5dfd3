// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ORIENTED_BOX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ORIENTED_BOX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Handle_tunnel_loops::internal {

/// A box along the principal axes of some points: that of a long or a flat cloud is as thin as the
/// cloud, whatever its direction. Coordinates of points are between -1 and 1. Boxes are larger than
/// they need be by a margin far above rounding, so no point is outside of its box, and boxes that
/// meet are never said not to.
class Oriented_box
{
public:
  using Vector = std::array<double, 3>;

  Oriented_box() = default;

  /// of at least one point; `for_each_point(f)` calls `f(p)` for each.
  template <typename For_each_point> explicit Oriented_box(const For_each_point& for_each_point) {
    std::array<Vector, 3> moments = second_moments(for_each_point);
    diagonalize(moments, axes_);
    Vector low, high;
    low.fill(8.);
    high.fill(-8.);
    for_each_point([&](const Vector& p) {
      for(std::size_t k = 0; k < 3; ++k) {
        low[k] = (std::min)(low[k], dot(axes_[k], p));
        high[k] = (std::max)(high[k], dot(axes_[k], p));
      }
    });
    center_ = {0., 0., 0.};
    for(std::size_t k = 0; k < 3; ++k) {
      half_[k] = 0.5 * (high[k] - low[k]) + margin;
      for(std::size_t i = 0; i < 3; ++i)
        center_[i] += 0.5 * (low[k] + high[k]) * axes_[k][i];
    }
  }

  const Vector& axis(std::size_t k) const { return axes_[k]; }
  double half_length(std::size_t k) const { return half_[k]; }

  /// 0 for a point between the two faces of the box that are nearest to each other, or about there;
  /// else 1 or -1, which tells the one side of both from the other.
  int side_of_slab(const Vector& p) const {
    const std::size_t k =
        static_cast<std::size_t>(std::min_element(half_.begin(), half_.end()) - half_.begin());
    const double height = dot(axes_[k], {p[0] - center_[0], p[1] - center_[1], p[2] - center_[2]});
    return std::abs(height) <= half_[k] + margin ? 0 : height > 0. ? 1 : -1;
  }

  const Vector& center() const { return center_; }

  double length() const { return *std::max_element(half_.begin(), half_.end()); }

  /// whether no axis of either, and none that is normal to one of each, separates them.
  bool meets(const Oriented_box& b) const {
    const Vector way = {b.center_[0] - center_[0], b.center_[1] - center_[1],
                        b.center_[2] - center_[2]};
    for(std::size_t i = 0; i < 3; ++i)
      if(is_separated(axes_[i], way, b) || is_separated(b.axes_[i], way, b))
        return false;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(is_separated(cross(axes_[i], b.axes_[j]), way, b))
          return false;
    return true;
  }

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

private:
  static constexpr double margin = 1e-12;

  bool is_separated(const Vector& axis, const Vector& way, const Oriented_box& b) const {
    return std::abs(dot(axis, way)) > radius(axis) + b.radius(axis) + margin;
  }

  double radius(const Vector& axis) const {
    double sum = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      sum += half_[k] * std::abs(dot(axes_[k], axis));
    return sum;
  }

  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  template <typename For_each_point>
  static std::array<Vector, 3> second_moments(const For_each_point& for_each_point) {
    Vector mean = {0., 0., 0.};
    double number = 0.;
    for_each_point([&](const Vector& p) {
      number += 1.;
      for(std::size_t i = 0; i < 3; ++i)
        mean[i] += (p[i] - mean[i]) / number;
    });
    std::array<Vector, 3> moments{};
    for_each_point([&](const Vector& p) {
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          moments[i][j] += (p[i] - mean[i]) * (p[j] - mean[j]);
    });
    return moments;
  }

  // Jacobi's method: a few rounds of rotations. Axes stay orthonormal, whatever is left beside the
  // diagonal.
  static void diagonalize(std::array<Vector, 3>& m, std::array<Vector, 3>& axes) {
    axes = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
    constexpr int number_of_rounds = 6;
    for(int round = 0; round < number_of_rounds; ++round)
      for(const auto& [p, q] : {std::make_pair(0, 1), std::make_pair(0, 2), std::make_pair(1, 2)})
        rotate(m, axes, static_cast<std::size_t>(p), static_cast<std::size_t>(q));
  }

  static void
  rotate(std::array<Vector, 3>& m, std::array<Vector, 3>& axes, std::size_t p, std::size_t q) {
    if(m[p][q] == 0.)
      return;
    const double angle = 0.5 * std::atan2(2. * m[p][q], m[q][q] - m[p][p]);
    const double c = std::cos(angle), s = std::sin(angle);
    for(std::size_t k = 0; k < 3; ++k) {
      const double x = m[k][p], y = m[k][q];
      m[k][p] = c * x - s * y;
      m[k][q] = s * x + c * y;
    }
    const auto turn = [c, s](Vector& a, Vector& b) {
      for(std::size_t k = 0; k < 3; ++k) {
        const double x = a[k], y = b[k];
        a[k] = c * x - s * y;
        b[k] = s * x + c * y;
      }
    };
    turn(m[p], m[q]);
    turn(axes[p], axes[q]);
  }

  Vector center_{}, half_{};
  std::array<Vector, 3> axes_{};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ORIENTED_BOX_H
