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

#include <CGAL/Handle_tunnel_loops/internal/surgery/Principal_axes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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
    axes_ = Principal_axes::of_points(for_each_point);
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

  /// 0 for a point between the two faces of the box that are nearest to each other, or about there;
  /// else 1 or -1, which tells the one side of both from the other.
  int side_of_slab(const Vector& p) const {
    const std::size_t k =
        static_cast<std::size_t>(std::min_element(half_.begin(), half_.end()) - half_.begin());
    const double height = dot(axes_[k], {p[0] - center_[0], p[1] - center_[1], p[2] - center_[2]});
    return std::abs(height) <= half_[k] + margin ? 0 : height > 0. ? 1 : -1;
  }

  const Vector& center() const { return center_; }

  /// whether no axis of either, and none that is normal to one of each, separates them.
  bool meets(const Oriented_box& b) const {
    const Vector way = {b.center_[0] - center_[0], b.center_[1] - center_[1],
                        b.center_[2] - center_[2]};
    // In the axes of this one.
    Vector w;
    std::array<Vector, 3> turn, size; // by axis of this and of b
    for(std::size_t i = 0; i < 3; ++i) {
      w[i] = dot(axes_[i], way);
      for(std::size_t j = 0; j < 3; ++j) {
        turn[i][j] = dot(axes_[i], b.axes_[j]);
        size[i][j] = std::abs(turn[i][j]);
      }
      if(std::abs(w[i]) > half_[i] + dot(b.half_, size[i]) + margin)
        return false;
    }
    for(std::size_t j = 0; j < 3; ++j)
      if(std::abs(w[0] * turn[0][j] + w[1] * turn[1][j] + w[2] * turn[2][j]) >
         half_[0] * size[0][j] + half_[1] * size[1][j] + half_[2] * size[2][j] + b.half_[j] +
             margin)
        return false;
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j) {
        const std::size_t p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
        if(std::abs(w[q] * turn[p][j] - w[p] * turn[q][j]) >
           half_[p] * size[q][j] + half_[q] * size[p][j] + b.half_[r] * size[i][s] +
               b.half_[s] * size[i][r] + margin)
          return false;
      }
    return true;
  }

  static double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

private:
  static constexpr double margin = 1e-12;

  Vector center_{}, half_{};
  std::array<Vector, 3> axes_{};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ORIENTED_BOX_H
