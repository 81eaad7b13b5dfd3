// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLES_APART_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLES_APART_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Handle_tunnel_loops::internal {

/// The corners of a triangle.
using Corner_points = std::array<Vector, 3>;

/// Tells two triangles apart where they are so by more than rounding.
class Triangles_apart
{
public:
  Triangles_apart(const Corner_points& s, const Corner_points& t)
      : s_(s)
      , t_(t) {
    for(const Corner_points* points : {&s, &t})
      for(const Vector& p : *points)
        for(std::size_t k = 0; k < 3; ++k)
          largest_ = (std::max)(largest_, std::abs(p[k]));
  }

  /// whether one ends, in a direction, before the other begins: a direction that is not quite the
  /// one that was meant says so, too.
  bool along(const Vector& direction) const {
    constexpr double margin = 1e-12, least = 1e-290, most = 1e290;
    const double size =
        (std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2])) * largest_;
    const auto extent = [&](const Corner_points& points) {
      const double a = dot(points[0], direction), b = dot(points[1], direction),
                   c = dot(points[2], direction);
      return std::make_pair((std::min)((std::min)(a, b), c), (std::max)((std::max)(a, b), c));
    };
    const auto [low_s, high_s] = extent(s_);
    const auto [low_t, high_t] = extent(t_);
    return size > least && size < most &&
           (std::max)(low_t - high_s, low_s - high_t) > margin * size;
  }

  /// in a direction normal to either, or to a side of it in its plane: as good as all that are not
  /// beside each other are where they lie in layers, or in a plane.
  bool operator()() const {
    const auto normal = [](const Corner_points& p) { return cross(p[1] - p[0], p[2] - p[0]); };
    const Vector n = normal(s_), m = normal(t_);
    if(along(n) || along(m))
      return true;
    for(std::size_t k = 0; k < 3; ++k)
      if(along(cross(n, s_[(k + 1) % 3] - s_[k])) || along(cross(m, t_[(k + 1) % 3] - t_[k])))
        return true;
    return false;
  }

private:
  const Corner_points &s_, &t_;
  double largest_ = 0.;
};

/// whether that is seen of two triangles.
inline bool are_seen_apart(const Corner_points& s, const Corner_points& t) {
  return Triangles_apart(s, t)();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLES_APART_H
