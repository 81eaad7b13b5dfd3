// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_PATCHED_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_PATCHED_SURFACE_H

#include "Field.h"
#include "Vertex_stars.h"
#include "generators.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A surface out of which triangles are taken and to which others are added. Numbers of vertices
/// and triangles stay what they are until it is taken.
class Patched_surface
{
public:
  explicit Patched_surface(Soup soup)
      : soup_(std::move(soup))
      , is_removed_(soup_.triangles.size(), 0) {}

  std::uint32_t add_point(const Vector& p) {
    soup_.points.push_back({p.x(), p.y(), p.z()});
    return static_cast<std::uint32_t>(soup_.points.size() - 1);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup_.triangles.push_back({a, b, c});
  }

  void remove(const Indices& triangles) {
    for(const std::uint32_t t : triangles)
      is_removed_[t] = 1;
  }

  /// joins two cycles of one size by a band, which is to the left of the lower one.
  void add_band(const Indices& lower, const Indices& upper) {
    for(std::size_t i = 0; i < lower.size(); ++i) {
      const std::size_t j = i + 1 == lower.size() ? 0 : i + 1;
      add_triangle(lower[i], lower[j], upper[i]);
      add_triangle(lower[j], upper[j], upper[i]);
    }
  }

  /// the surface, without the vertices that no triangle has any more.
  Soup take() {
    Soup rest;
    constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
    Indices new_index(soup_.points.size(), none);
    for(std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      if(t < is_removed_.size() && is_removed_[t] != 0)
        continue;
      rest.triangles.push_back(soup_.triangles[t]);
      for(const std::uint32_t v : soup_.triangles[t])
        new_index[v] = 0;
    }
    for(std::size_t v = 0; v < new_index.size(); ++v)
      if(new_index[v] != none) {
        new_index[v] = static_cast<std::uint32_t>(rest.points.size());
        rest.points.push_back(soup_.points[v]);
      }
    for(auto& triangle : rest.triangles)
      for(std::uint32_t& v : triangle)
        v = new_index[v];
    return rest;
  }

private:
  Soup soup_;
  std::vector<char> is_removed_; ///< of the triangles that were there first
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_PATCHED_SURFACE_H
