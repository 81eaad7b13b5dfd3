// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "smoothing.h"

#include "vertex_normals.h"

#include <algorithm>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// moves each vertex by `factor` times the way to the mean of its neighbours.
class Laplacian_step
{
public:
  explicit Laplacian_step(Soup& soup)
      : soup_(soup)
      , degree_(soup.points.size(), 0)
      , sum_(soup.points.size()) {
    for(const auto& triangle : soup.triangles)
      for(std::uint32_t v : triangle)
        ++degree_[v];
  }

  void operator()(double factor) {
    sum_.assign(sum_.size(), {0., 0., 0.});
    for(const auto& [a, b, c] : soup_.triangles) {
      // Each edge is seen once in each direction: from a to b here, from b to a across it.
      add(a, b);
      add(b, c);
      add(c, a);
    }
    for(std::size_t v = 0; v < sum_.size(); ++v)
      if(degree_[v] != 0)
        for(int i = 0; i < 3; ++i)
          soup_.points[v][i] += factor * (sum_[v][i] / degree_[v] - soup_.points[v][i]);
  }

private:
  void add(std::uint32_t to, std::uint32_t from) {
    for(int i = 0; i < 3; ++i)
      sum_[to][i] += soup_.points[from][i];
  }

  Soup& soup_;
  std::vector<std::uint32_t> degree_;
  std::vector<std::array<double, 3>> sum_;
};

} // namespace

void approach_surface(Soup& soup, const Field& field, double limit) {
  const std::vector<Vector> normals = vertex_normals(soup);
  for(std::uint32_t v = 0; v < soup.points.size(); ++v) {
    const double normal_length = length(normals[v]);
    if(normal_length == 0.)
      continue;
    const Vector p = point_of(soup, v);
    const Vector q = p - std::clamp(field(p), -limit, limit) / normal_length * normals[v];
    soup.points[v] = {q.x(), q.y(), q.z()};
  }
}

void relax(Soup& soup, int rounds) {
  Laplacian_step step(soup);
  for(int round = 0; round < rounds; ++round)
    step(0.5);
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
