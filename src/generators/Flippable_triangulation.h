// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FLIPPABLE_TRIANGULATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FLIPPABLE_TRIANGULATION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A closed oriented combinatorial surface that stays a simplicial complex while it is changed.
/// Halfedge h is in triangle h / 3, starts at `source(h)` and is followed by `next(h)`.
class Flippable_triangulation
{
public:
  using Index = std::uint32_t;
  using Triangle = std::array<Index, 3>;

  Flippable_triangulation(const std::vector<Triangle>& triangles, Index number_of_vertices)
      : number_of_vertices_(number_of_vertices) {
    for(const Triangle& triangle : triangles)
      source_.insert(source_.end(), triangle.begin(), triangle.end());
    pair_halfedges();
  }

  Index number_of_vertices() const { return number_of_vertices_; }
  std::size_t number_of_triangles() const { return source_.size() / 3; }
  std::size_t number_of_halfedges() const { return source_.size(); }
  Triangle triangle(std::size_t t) const {
    return {source_[3 * t], source_[3 * t + 1], source_[3 * t + 2]};
  }

  /// replaces an edge by the other diagonal of its two triangles, unless that is an edge already.
  bool flip(Index h) {
    const Index g = opposite_[h];
    const Index hn = next(h), hp = next(hn), gn = next(g), gp = next(gn);
    const Index a = source_[h], b = source_[g], c = source_[hp], d = source_[gp];
    if(!edges_.insert(key(c, d)).second)
      return false;
    edges_.erase(key(a, b));
    // Triangle (a, b, c) becomes (d, b, c), triangle (b, a, d) becomes (c, a, d).
    source_[h] = d;
    source_[g] = c;
    const Index beyond_hp = opposite_[hp], beyond_gp = opposite_[gp];
    link(h, beyond_gp);
    link(g, beyond_hp);
    link(hp, gp);
    return true;
  }

  /// puts a new vertex into a triangle.
  void split_triangle(Index t) {
    const auto [a, b, c] = triangle(t);
    const Index v = number_of_vertices_++;
    const Index ab = 3 * t, bc = ab + 1, ca = ab + 2;
    const Index beyond_bc = opposite_[bc], beyond_ca = opposite_[ca];
    const Index second = add_triangle({b, c, v}), third = add_triangle({c, a, v});
    source_[ca] = v; // (a, b, c) becomes (a, b, v)
    link(second, beyond_bc);
    link(third, beyond_ca);
    link(bc, second + 2);
    link(second + 1, third + 2);
    link(third + 1, ca);
    for(Index corner : {a, b, c})
      edges_.insert(key(corner, v));
  }

private:
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }

  static std::uint64_t key(Index a, Index b) {
    return std::uint64_t((std::min)(a, b)) << 32 | (std::max)(a, b);
  }

  void link(Index g, Index h) {
    opposite_[g] = h;
    opposite_[h] = g;
  }

  Index add_triangle(const Triangle& triangle) {
    const Index first = static_cast<Index>(source_.size());
    source_.insert(source_.end(), triangle.begin(), triangle.end());
    opposite_.resize(source_.size());
    return first;
  }

  void pair_halfedges() {
    opposite_.resize(source_.size());
    std::unordered_map<std::uint64_t, Index> waiting; // by edge: the halfedge that was seen first
    for(Index h = 0; h < source_.size(); ++h) {
      const std::uint64_t edge = key(source_[h], source_[next(h)]);
      const auto [it, is_first] = waiting.try_emplace(edge, h);
      if(!is_first)
        link(it->second, h);
      edges_.insert(edge);
    }
  }

  Index number_of_vertices_;
  std::vector<Index> source_, opposite_;
  std::unordered_set<std::uint64_t> edges_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FLIPPABLE_TRIANGULATION_H
