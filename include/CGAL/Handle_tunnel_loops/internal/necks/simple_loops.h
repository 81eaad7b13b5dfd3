// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_SIMPLE_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_SIMPLE_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

template <typename T> bool has_repetition(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

/// whether a closed walk on the edges, given by its vertices with repetitions where it stays,
/// visits three vertices or more, and none of them twice.
inline bool is_simple_walk(std::vector<Index> vertices) {
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  while(vertices.size() > 1 && vertices.front() == vertices.back())
    vertices.pop_back();
  return vertices.size() >= 3 && !has_repetition(vertices);
}

/// whether a loop passes no edge twice, and can be moved aside to a simple walk on the edges.
inline bool is_simple(const Crossing_loop& loop) {
  std::vector<std::pair<Index, Index>> edges;
  std::vector<Index> left, right;
  for(const Crossing& c : loop) {
    edges.push_back(std::minmax(c.left, c.right));
    left.push_back(c.left);
    right.push_back(c.right);
  }
  return !has_repetition(edges) && (is_simple_walk(left) || is_simple_walk(right));
}

/// Chooses loops no two of which pass edges with a common end.
class Disjoint_loops
{
public:
  explicit Disjoint_loops(const Flat_mesh& mesh)
      : is_taken_(mesh.number_of_vertices(), 0) {}

  /// takes a loop, unless it comes too near to one that was taken before.
  bool take(const Crossing_loop& loop) {
    for(const Crossing& c : loop)
      if(is_taken_[c.left] != 0 || is_taken_[c.right] != 0)
        return false;
    for(const Crossing& c : loop)
      is_taken_[c.left] = is_taken_[c.right] = 1;
    return true;
  }

private:
  std::vector<char> is_taken_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_SIMPLE_LOOPS_H
