// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_VERTEX_NORMALS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_VERTEX_NORMALS_H

#include "Field.h"
#include "generators.h"

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

inline Vector point_of(const Soup& soup, std::uint32_t v) {
  const auto& [x, y, z] = soup.points[v];
  return Vector(x, y, z);
}

inline double mean_edge_length(const Soup& soup) {
  double sum = 0.;
  for(const auto& triangle : soup.triangles)
    for(int i = 0; i < 3; ++i)
      sum += length(point_of(soup, triangle[i]) - point_of(soup, triangle[(i + 1) % 3]));
  return sum / (3. * static_cast<double>(soup.triangles.size()));
}

/// for each vertex the sum of the normals of its triangles, each as long as twice its area.
inline std::vector<Vector> vertex_normals(const Soup& soup) {
  std::vector<Vector> normals(soup.points.size(), Vector(0, 0, 0));
  for(const auto& [a, b, c] : soup.triangles) {
    const Vector p = point_of(soup, a);
    const Vector normal = CGAL::cross_product(point_of(soup, b) - p, point_of(soup, c) - p);
    for(const std::uint32_t v : {a, b, c})
      normals[v] += normal;
  }
  return normals;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_VERTEX_NORMALS_H
