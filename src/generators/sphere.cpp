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
  void add_point(const Vector& p) {
    const Vector q = p / length(p);
    soup_.points.push_back({q.x(), q.y(), q.z()});
  }

  /// the first of the n - 1 vertices inside an edge, in the order from its lower corner.
  std::uint32_t edge_start(int low, int high) {
    const auto next = static_cast<std::uint32_t>(soup_.points.size());
    const auto [it, is_new] = edges_.try_emplace({low, high}, next);
    if(is_new)
      for(std::uint32_t i = 1; i < n_; ++i)
        add_point(base_.corners[low] * (n_ - i) + base_.corners[high] * i);
    return it->second;
  }

  std::uint32_t on_edge(int from, int to, std::uint32_t i) {
    return from < to ? edge_start(from, to) + i - 1 : edge_start(to, from) + (n_ - i) - 1;
  }

  /// the vertex of a face with barycentric coordinates (n - i - j, i, j).
  std::uint32_t
  vertex(const std::array<int, 3>& face, std::uint32_t inner, std::uint32_t i, std::uint32_t j) {
    const auto [a, b, c] = face;
    if(i + j == 0)
      return a;
    if(i == n_)
      return b;
    if(j == n_)
      return c;
    if(j == 0)
      return on_edge(a, b, i);
    if(i == 0)
      return on_edge(a, c, j);
    if(i + j == n_)
      return on_edge(b, c, j);
    // Row j of the inner vertices has n - 1 - j of them.
    return inner + (j - 1) * (n_ - 1) - (j - 1) * j / 2 + (i - 1);
  }

  void subdivide(const std::array<int, 3>& face) {
    const auto [a, b, c] = face;
    for(const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edge_start((std::min)(p, q), (std::max)(p, q));

    const auto inner = static_cast<std::uint32_t>(soup_.points.size());
    for(std::uint32_t j = 1; j + 1 < n_; ++j)
      for(std::uint32_t i = 1; i + j < n_; ++i)
        add_point(base_.corners[a] * (n_ - i - j) + base_.corners[b] * i + base_.corners[c] * j);
    for(std::uint32_t j = 0; j < n_; ++j)
      for(std::uint32_t i = 0; i + j < n_; ++i) {
        const auto right = vertex(face, inner, i + 1, j), up = vertex(face, inner, i, j + 1);
        soup_.triangles.push_back({vertex(face, inner, i, j), right, up});
        if(i + j + 1 < n_)
          soup_.triangles.push_back({right, vertex(face, inner, i + 1, j + 1), up});
      }
  }

  const Base& base_;
  std::uint32_t n_;
  Soup soup_;
  std::map<std::pair<int, int>, std::uint32_t> edges_;
};

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

} // namespace

const Kind sphere_kind = {"sphere",    "a sphere, a subdivided icosahedron; genus 0, from 4 faces",
                          make_sphere, GENUS,
                          10000,       0};

} // namespace CGAL::Handle_tunnel_loops::generators
