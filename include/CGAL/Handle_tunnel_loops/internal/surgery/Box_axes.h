// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BOX_AXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BOX_AXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/triangles_apart.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Axes along which boxes around triangles are small: those of the coordinates, unless others are
/// clearly better, as they are for long triangles of a part that lies askew. They are a turn away
/// from these, so that distances are the same.
class Box_axes
{
public:
  Box_axes() = default;

  /// for surfaces like some triangles. Tried are axes along the largest of them.
  explicit Box_axes(const std::vector<Corner_points>& triangles) {
    constexpr std::size_t number_tried = 16;
    constexpr double clearly = 0.8, by_more_than_rounding = 1. - 1e-9;
    std::vector<std::pair<double, std::size_t>> by_size;
    for(std::size_t i = 0; i < triangles.size(); ++i)
      if(const double size = box_size(triangles[i]); std::isfinite(size))
        by_size.push_back({size, i});
    const auto end =
        by_size.begin() + static_cast<std::ptrdiff_t>((std::min)(number_tried, by_size.size()));
    std::partial_sort(by_size.begin(), end, by_size.end(), std::greater<>());
    double least = clearly * sum_of_box_sizes(triangles);
    for(auto i = by_size.begin(); i != end; ++i) {
      Box_axes other;
      other.turn_along(triangles[i->second]);
      const double sum = other.sum_of_box_sizes(triangles);
      if(sum < least) {
        least = by_more_than_rounding * sum;
        *this = other;
      }
    }
  }

  /// a point by its coordinates along the axes, rounded.
  Vector turned(const Vector& p) const {
    return is_turned_ ? Vector{dot(axes_[0], p), dot(axes_[1], p), dot(axes_[2], p)} : p;
  }

  /// a box around a point, which is as large as rounding: boxes of triangles that meet do so.
  Box<3> box(const Vector& p) const {
    constexpr double margin = 0x1p-50, least = 0x1p-1070;
    const Vector t = turned(p);
    const double size = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
    const double rounding = is_turned_ ? margin * size + least : 0.;
    return {{t[0] - rounding, t[1] - rounding, t[2] - rounding},
            {t[0] + rounding, t[1] + rounding, t[2] + rounding}};
  }

  Box<3> box(const Corner_points& triangle) const {
    Box<3> all = box(triangle[0]);
    all.extend(box(triangle[1]));
    all.extend(box(triangle[2]));
    return all;
  }

private:
  // Along its longest side, and normal to it, whatever that is of a sliver; not at all if these are
  // no directions.
  void turn_along(const Corner_points& t) {
    const auto side = [&](std::size_t k) { return t[(k + 1) % 3] - t[k]; };
    std::size_t longest = 0;
    for(std::size_t k = 1; k < 3; ++k)
      if(dot(side(k), side(k)) > dot(side(longest), side(longest)))
        longest = k;
    const Vector along = unit(side(longest));
    Vector normal = unit(cross(side(0), side(1)));
    for(int round = 0; round < 2; ++round)
      normal = unit(normal - dot(normal, along) * along);
    is_turned_ = norm(along) > 0. && norm(normal) > 0.;
    axes_ = {along, normal, cross(along, normal)};
  }

  // Half of its surface: boxes are the more likely to meet others.
  double box_size(const Corner_points& triangle) const {
    const Box<3> b = box(triangle);
    const double x = b.high[0] - b.low[0], y = b.high[1] - b.low[1], z = b.high[2] - b.low[2];
    return rounded_product(x, y) + rounded_product(y, z) + rounded_product(z, x);
  }

  double sum_of_box_sizes(const std::vector<Corner_points>& triangles) const {
    double sum = 0.;
    for(const Corner_points& t : triangles)
      sum += box_size(t);
    return sum;
  }

  bool is_turned_ = false;
  std::array<Vector, 3> axes_{};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BOX_AXES_H
