// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Field.h"
#include "kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// A polyhedron with triangular faces whose vertices lie on a sphere around the origin.
struct Base
{
  std::vector<Vector> corners;
  std::vector<std::array<int, 3>> faces;
};

Base tetrahedron() {
  return {{Vector(1, 1, 1), Vector(1, -1, -1), Vector(-1, 1, -1), Vector(-1, -1, 1)},
          {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

Base octahedron() {
  return {{Vector(1, 0, 0), Vector(-1, 0, 0), Vector(0, 1, 0), Vector(0, -1, 0), Vector(0, 0, 1),
           Vector(0, 0, -1)},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

Base icosahedron() {
  const double g = (1. + std::sqrt(5.)) / 2.;
  return {{Vector(-1, g, 0), Vector(1, g, 0), Vector(-1, -g, 0), Vector(1, -g, 0), Vector(0, -1, g),
           Vector(0, 1, g), Vector(0, -1, -g), Vector(0, 1, -g), Vector(g, 0, -1), Vector(g, 0, 1),
           Vector(-g, 0, -1), Vector(-g, 0, 1)},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Cuts each face of a polyhedron into n^2 triangles and moves the vertices to the unit sphere.
class Sphere_builder
{
public:
  Sphere_builder(const Base& base, std::uint32_t n)
      : base_(base)
      , n_(n) {
    for(const Vector& corner : base_.corners)
      add_point(corner);
    for(const auto& face : base_.faces)
      subdivide(face);
  }

  Soup take() { return std::move(soup_); }

private:
  std::uint32_t add_point(const Vector& p) { return generators::add_point(soup_, unit(p)); }

  /// the i-th vertex on the way from one corner to another, which are those for 0 and n.
  std::uint32_t on_edge(int from, int to, std::uint32_t i) {
    if(i == 0 || i == n_)
      return i == 0 ? from : to;
    if(from > to)
      return on_edge(to, from, n_ - i);
    const auto next = static_cast<std::uint32_t>(soup_.points.size());
    const auto [it, is_new] = edges_.try_emplace({from, to}, next);
    if(is_new)
      for(std::uint32_t k = 1; k < n_; ++k)
        add_point(base_.corners[from] * (n_ - k) + base_.corners[to] * k);
    return it->second + i - 1;
  }

  void subdivide(const std::array<int, 3>& face) {
    const auto [a, b, c] = face;
    // By j and i: the vertex with barycentric coordinates (n - i - j, i, j).
    std::vector<std::vector<std::uint32_t>> at(n_ + 1, std::vector<std::uint32_t>(n_ + 1));
    for(std::uint32_t i = 0; i <= n_; ++i)
      at[0][i] = on_edge(a, b, i);
    for(std::uint32_t j = 0; j <= n_; ++j)
      at[j][n_ - j] = on_edge(b, c, j);
    for(std::uint32_t j = 0; j <= n_; ++j)
      at[j][0] = on_edge(a, c, j);
    for(std::uint32_t j = 1; j + 1 < n_; ++j)
      for(std::uint32_t i = 1; i + j < n_; ++i)
        at[j][i] = add_point(base_.corners[a] * (n_ - i - j) + base_.corners[b] * i +
                             base_.corners[c] * j);
    for(std::uint32_t j = 0; j < n_; ++j)
      for(std::uint32_t i = 0; i + j < n_; ++i) {
        soup_.triangles.push_back({at[j][i], at[j][i + 1], at[j + 1][i]});
        if(i + j + 1 < n_)
          soup_.triangles.push_back({at[j][i + 1], at[j + 1][i + 1], at[j + 1][i]});
      }
  }

  const Base& base_;
  std::uint32_t n_;
  Soup soup_;
  std::map<std::pair<int, int>, std::uint32_t> edges_; ///< the first vertex inside each
};

} // namespace

Soup make_sphere(const Request& request) {
  require_genus(request, "sphere", 0);
  require_faces(request, "sphere", 4);

  // Of the numbers of faces 4 n^2, 8 n^2 and 20 n^2, the one closest to that asked for.
  Base best_base;
  double best_n = 0., best_error = std::numeric_limits<double>::infinity();
  for(const Base& base : {icosahedron(), octahedron(), tetrahedron()}) {
    const double n =
        (std::max)(1., std::round(std::sqrt(double(request.faces) / base.faces.size())));
    const double error = std::abs(base.faces.size() * n * n - request.faces);
    // The icosahedron has the most even triangles: prefer it where it is good enough.
    if(best_error > 0.05 * request.faces && error < best_error) {
      best_base = base;
      best_n = n;
      best_error = error;
    }
  }
  return Sphere_builder(best_base, static_cast<std::uint32_t>(best_n)).take();
}

} // namespace CGAL::Handle_tunnel_loops::generators
