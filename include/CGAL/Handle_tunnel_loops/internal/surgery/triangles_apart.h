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

/// Three points, with coordinates between -1 and 1.
using Corner_points = std::array<Vector, 3>;

/// Whether one triangle ends, in a direction, before the other begins, by more than rounding: a
/// direction that is not quite the one that was meant says so, too.
inline bool
are_apart_along(const Vector& direction, const Corner_points& s, const Corner_points& t) {
  constexpr double margin = 1e-12, least = 1e-300;
  const double size = std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]);
  const auto extent = [&](const Corner_points& points) {
    const double a = dot(points[0], direction), b = dot(points[1], direction),
                 c = dot(points[2], direction);
    return std::make_pair((std::min)((std::min)(a, b), c), (std::max)((std::max)(a, b), c));
  };
  const auto [low_s, high_s] = extent(s);
  const auto [low_t, high_t] = extent(t);
  return size > least && (std::max)(low_t - high_s, low_s - high_t) > margin * size;
}

/// Whether two triangles are apart in a direction normal to either, or to a side of it in its
/// plane: as good as all that are not beside each other are where they lie in layers, or in a
/// plane.
inline bool are_seen_apart(const Corner_points& s, const Corner_points& t) {
  const auto normal = [](const Corner_points& p) { return cross(p[1] - p[0], p[2] - p[0]); };
  const Vector n = normal(s), m = normal(t);
  if(are_apart_along(n, s, t) || are_apart_along(m, s, t))
    return true;
  for(std::size_t k = 0; k < 3; ++k)
    if(are_apart_along(cross(n, s[(k + 1) % 3] - s[k]), s, t) ||
       are_apart_along(cross(m, t[(k + 1) % 3] - t[k]), s, t))
      return true;
  return false;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLES_APART_H
