// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_VERTEX_STARS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_VERTEX_STARS_H

#include "generators.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

using Indices = std::vector<std::uint32_t>;

/// Which triangles of a surface are at each vertex.
class Vertex_stars
{
public:
  explicit Vertex_stars(const Soup& soup)
      : soup_(soup)
      , begin_(soup.points.size() + 1, 0)
      , triangles_(3 * soup.triangles.size()) {
    for(const auto& triangle : soup.triangles)
      for(const std::uint32_t v : triangle)
        ++begin_[v];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for(std::uint32_t t = 0; t < soup.triangles.size(); ++t)
      for(const std::uint32_t v : soup.triangles[t])
        triangles_[--begin_[v]] = t;
  }

  /// the triangles at the vertices up to `rings - 1` edges away.
  Indices triangles_around(std::uint32_t centre, int rings) const {
    Indices vertices = {centre}, triangles;
    while(true) {
      for(const std::uint32_t v : vertices)
        triangles.insert(triangles.end(), triangles_.begin() + begin_[v],
                         triangles_.begin() + begin_[v + 1]);
      make_unique(triangles);
      if(--rings == 0)
        return triangles;
      for(const std::uint32_t t : triangles)
        vertices.insert(vertices.end(), soup_.triangles[t].begin(), soup_.triangles[t].end());
      make_unique(vertices);
    }
  }

  /// the boundary of a set of triangles, to the left of which they are, if it is one cycle without
  /// a vertex twice; otherwise nothing.
  Indices boundary(const Indices& triangles) const {
    std::map<std::uint32_t, std::uint32_t> next;
    for(const auto& [u, v] : edges_without_opposite(triangles))
      if(!next.emplace(u, v).second)
        return {};
    Indices cycle;
    if(next.empty())
      return cycle;
    std::uint32_t v = next.begin()->first;
    do {
      cycle.push_back(v);
      v = next.at(v);
    } while(v != cycle.front());
    return cycle.size() == next.size() ? cycle : Indices();
  }

private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  static void make_unique(Indices& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }

  std::vector<Edge> edges_without_opposite(const Indices& triangles) const {
    std::vector<Edge> edges, rest;
    for(const std::uint32_t t : triangles)
      for(int i = 0; i < 3; ++i)
        edges.emplace_back(soup_.triangles[t][i], soup_.triangles[t][(i + 1) % 3]);
    std::sort(edges.begin(), edges.end());
    for(const auto& [u, v] : edges)
      if(!std::binary_search(edges.begin(), edges.end(), Edge(v, u)))
        rest.emplace_back(u, v);
    return rest;
  }

  const Soup& soup_;
  Indices begin_, triangles_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_VERTEX_STARS_H
