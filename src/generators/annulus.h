// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ANNULUS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ANNULUS_H

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

using Point_2 = std::array<double, 2>;

inline double cross(const Point_2& o, const Point_2& p, const Point_2& q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

/// by how much one direction is counterclockwise of another, in [-pi, pi].
inline double turn(const Point_2& from, const Point_2& to) {
  return std::atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
}

/*!
Triangles between two cycles in the plane around the origin, both counterclockwise, one within the
other. Corners below the size of the outer cycle are its vertices, the others those of the inner
one. Nothing if the triangles overlapped: those here are all counterclockwise and go around once.
*/
inline std::vector<std::array<std::uint32_t, 3>> annulus(const std::vector<Point_2>& outer,
                                                         const std::vector<Point_2>& inner) {
  const auto n = static_cast<std::uint32_t>(outer.size());
  const auto m = static_cast<std::uint32_t>(inner.size());
  std::uint32_t nearest = 0;
  for(std::uint32_t j = 1; j < m; ++j)
    if(std::abs(turn(outer[0], inner[j])) < std::abs(turn(outer[0], inner[nearest])))
      nearest = j;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double angle = 0., inner_angle = turn(outer[0], inner[nearest]);
  for(std::uint32_t i = 0, j = 0; i < n || j < m;) {
    const std::uint32_t u = i % n, next_u = (i + 1) % n;
    const std::uint32_t v = (nearest + j) % m, next_v = (nearest + j + 1) % m;
    const double step = turn(outer[u], outer[next_u]), inner_step = turn(inner[v], inner[next_v]);
    if(step <= 0. || inner_step <= 0.)
      return {};
    // The edge whose middle comes first.
    if(j == m || (i < n && angle + step / 2. <= inner_angle + inner_step / 2.)) {
      if(cross(outer[u], outer[next_u], inner[v]) <= 0.)
        return {};
      triangles.push_back({u, next_u, n + v});
      angle += step;
      ++i;
    } else {
      if(cross(outer[u], inner[next_v], inner[v]) <= 0.)
        return {};
      triangles.push_back({u, n + next_v, n + v});
      inner_angle += inner_step;
      ++j;
    }
  }
  const bool is_once_around = std::abs(angle - 2. * CGAL_PI) < 1e-6;
  return is_once_around ? triangles : std::vector<std::array<std::uint32_t, 3>>();
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ANNULUS_H
