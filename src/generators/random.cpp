// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Random.h"
#include "functions.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// A closed oriented combinatorial surface that stays a simplicial complex while it is changed.
/// Halfedge h is in triangle h / 3, starts at `source(h)` and is followed by `next(h)`.
class Flippable_triangulation
{
public:
  using Index = std::uint32_t;
  using Triangle = std::array<Index, 3>;

  Flippable_triangulation(const std::vector<Triangle>& triangles, Index number_of_vertices)
      : number_of_vertices_(number_of_vertices)
      , triangles_(triangles) {
    pair_halfedges();
  }

  Index number_of_vertices() const { return number_of_vertices_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// replaces an edge by the other diagonal of its two triangles, unless that is an edge already.
  bool flip(Index h) {
    const Index g = opposite_[h];
    const Index hn = next(h), hp = next(hn), gn = next(g), gp = next(gn);
    const Index a = source(h), b = source(g), c = source(hp), d = source(gp);
    if(!edges_.insert(key(c, d)).second)
      return false;
    edges_.erase(key(a, b));
    // Triangle (a, b, c) becomes (d, b, c), triangle (b, a, d) becomes (c, a, d).
    source(h) = d;
    source(g) = c;
    const Index beyond_hp = opposite_[hp], beyond_gp = opposite_[gp];
    link(h, beyond_gp);
    link(g, beyond_hp);
    link(hp, gp);
    return true;
  }

  /// puts a new vertex into a triangle.
  void split_triangle(Index t) {
    const auto [a, b, c] = triangles_[t];
    const Index v = number_of_vertices_++;
    const Index ab = 3 * t, bc = ab + 1, ca = ab + 2;
    const Index beyond_bc = opposite_[bc], beyond_ca = opposite_[ca];
    const Index second = add_triangle({b, c, v}), third = add_triangle({c, a, v});
    source(ca) = v; // (a, b, c) becomes (a, b, v)
    link(second, beyond_bc);
    link(third, beyond_ca);
    link(bc, second + 2);
    link(second + 1, third + 2);
    link(third + 1, ca);
    for(Index corner : {a, b, c})
      edges_.insert(key(corner, v));
  }

private:
  Index& source(Index h) { return triangles_[h / 3][h % 3]; }
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }

  static std::uint64_t key(Index a, Index b) {
    return std::uint64_t((std::min)(a, b)) << 32 | (std::max)(a, b);
  }

  void link(Index g, Index h) {
    opposite_[g] = h;
    opposite_[h] = g;
  }

  Index add_triangle(const Triangle& triangle) {
    triangles_.push_back(triangle);
    opposite_.resize(3 * triangles_.size());
    return static_cast<Index>(opposite_.size() - 3);
  }

  void pair_halfedges() {
    opposite_.resize(3 * triangles_.size());
    std::unordered_map<std::uint64_t, Index> waiting; // by edge: the halfedge that was seen first
    for(Index h = 0; h < opposite_.size(); ++h) {
      const std::uint64_t edge = key(source(h), source(next(h)));
      const auto [it, is_first] = waiting.try_emplace(edge, h);
      if(!is_first)
        link(it->second, h);
      edges_.insert(edge);
    }
  }

  Index number_of_vertices_;
  std::vector<Triangle> triangles_;
  std::vector<Index> opposite_;
  std::unordered_set<std::uint64_t> edges_;
};

using Triangle = Flippable_triangulation::Triangle;

/// A surface as a list of triangles.
struct Surface
{
  std::vector<Triangle> triangles;
  std::uint32_t number_of_vertices;
};

Surface smallest_sphere() { return {{{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, 4}; }

/// the torus with seven vertices, each of which is joined to all others.
Surface smallest_torus() {
  Surface torus{{}, 7};
  for(std::uint32_t i = 0; i < 7; ++i) {
    torus.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    torus.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return torus;
}

/// glues a torus in place of a triangle.
void add_handle(Surface& surface, std::size_t t) {
  const Surface torus = smallest_torus();
  const Triangle removed = torus.triangles.front(), hole = surface.triangles[t];
  std::array<std::uint32_t, 7> image{};
  for(std::uint32_t v = 0; v < 7; ++v)
    if(std::find(removed.begin(), removed.end(), v) == removed.end())
      image[v] = surface.number_of_vertices++;
  // Turned over, so that the two sides of the cut are traversed in opposite directions.
  image[removed[0]] = hole[0];
  image[removed[1]] = hole[2];
  image[removed[2]] = hole[1];

  for(std::size_t i = 1; i < torus.triangles.size(); ++i) {
    const auto& [a, b, c] = torus.triangles[i];
    const Triangle triangle = {image[a], image[b], image[c]};
    if(i == 1)
      surface.triangles[t] = triangle;
    else
      surface.triangles.push_back(triangle);
  }
}

void flip_edges(Flippable_triangulation& surface, std::size_t times, Random& random) {
  for(std::size_t i = 0; i < times; ++i)
    surface.flip(static_cast<std::uint32_t>(random.below(3 * surface.triangles().size())));
}

Flippable_triangulation random_triangulation(std::size_t genus, std::size_t faces, Random& random) {
  Surface start = genus == 0 ? smallest_sphere() : smallest_torus();
  for(std::size_t handle = 1; handle < genus; ++handle)
    add_handle(start, random.below(start.triangles.size()));

  Flippable_triangulation surface(start.triangles, start.number_of_vertices);
  while(surface.triangles().size() + 2 <= faces) {
    surface.split_triangle(static_cast<std::uint32_t>(random.below(surface.triangles().size())));
    flip_edges(surface, 2, random);
  }
  // From hardly mixed to thoroughly.
  flip_edges(surface, 3 * surface.triangles().size() * random.below(4), random);
  return surface;
}

/// moves vertices together that are close on the surface.
void pull_together(Soup& soup, Random& random) {
  relax(soup, 5 + static_cast<int>(random.below(30)));
  for(int axis = 0; axis < 3; ++axis) {
    double largest = 0.;
    for(const auto& point : soup.points)
      largest = (std::max)(largest, std::abs(point[axis]));
    for(auto& point : soup.points)
      point[axis] /= largest > 0. ? largest : 1.;
  }
}

/// makes the surface very small or very large, and flat.
void flatten(Soup& soup, Random& random) {
  const double scale = power(10., random.uniform(-9., 9.));
  const std::array<double, 3> stretch = {scale, scale, scale * 1e-6};
  for(auto& point : soup.points)
    for(int axis = 0; axis < 3; ++axis)
      point[axis] *= stretch[axis];
}

/// moves vertices almost, or quite, onto neighbours.
void collapse_edges(Soup& soup, Random& random) {
  for(std::size_t i = 0; i < soup.points.size() / 3; ++i) {
    const Triangle& triangle = soup.triangles[random.below(soup.triangles.size())];
    const double rest = random.below(4) == 0 ? 0. : power(10., random.uniform(-12., -1.));
    auto& moved = soup.points[triangle[0]];
    const auto& target = soup.points[triangle[1]];
    for(int axis = 0; axis < 3; ++axis)
      moved[axis] = target[axis] + rest * (moved[axis] - target[axis]);
  }
}

/// from a cloud of points to nearly degenerate.
void place_vertices(Soup& soup, Random& random) {
  for(auto& point : soup.points)
    for(double& x : point)
      x = random.uniform(-1., 1.);
  const std::size_t manner = random.below(4);
  if(manner != 0)
    pull_together(soup, random);
  if(manner == 2)
    flatten(soup, random);
  if(manner == 3)
    collapse_edges(soup, random);
}

} // namespace

Soup make_random(const Request& request) {
  // The smallest sphere has 4 triangles, the smallest torus 14; each further torus replaces one
  // triangle.
  require_faces(request, "random", request.genus == 0 ? 4 : 2 + 12 * request.genus);

  Random random(request.seed);
  const auto surface = random_triangulation(request.genus, request.faces, random);
  Soup soup;
  soup.triangles = surface.triangles();
  soup.points.resize(surface.number_of_vertices());
  place_vertices(soup, random);
  return permute_vertices(soup, static_cast<unsigned>(random.next()));
}

} // namespace CGAL::Handle_tunnel_loops::generators
