// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_EDGES_AT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_EDGES_AT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The numbers of the edges at each vertex of a graph, in their order.
class Edges_at
{
public:
  Edges_at() = default;

  /// \p edges is a range of pairs of vertices.
  template <typename Edges>
  Edges_at(std::size_t number_of_vertices, const Edges& edges)
      : begin_(number_of_vertices + 1, 0)
      , edges_(2 * edges.size()) {
    for(const auto& [u, v] : edges) {
      ++begin_[u + 1];
      ++begin_[v + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    Index e = 0;
    for(const auto& [u, v] : edges) {
      edges_[next[u]++] = e;
      edges_[next[v]++] = e++;
    }
  }

  Span<const Index> operator[](Index v) const {
    return {edges_.data() + begin_[v], begin_[v + 1] - begin_[v]};
  }

private:
  std::vector<Index> begin_, edges_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_EDGES_AT_H
