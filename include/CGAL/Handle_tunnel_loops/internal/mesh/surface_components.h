// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_SURFACE_COMPONENTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_SURFACE_COMPONENTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Disjoint sets of numbers, each with its smallest number as representative.
class Sets_of_indices
{
public:
  /// each number below `n` by itself.
  explicit Sets_of_indices(std::size_t n)
      : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), Index(0));
  }

  /// a number of the same set, smaller than `i` if there is one.
  Index parent(Index i) const { return parent_[i]; }

  /// the representative of the set of `i`.
  Index find(Index i) const {
    while(parent_[i] != i)
      i = parent_[i];
    return i;
  }

  /// joins the sets of `i` and `j`, and says whether they were two; on the way there, makes the
  /// next one shorter.
  bool unite(Index i, Index j) {
    if(parent_[i] == parent_[j])
      return false;
    i = shorten(i);
    j = shorten(j);
    parent_[(std::max)(i, j)] = (std::min)(i, j);
    CGAL_postcondition(parent_[i] <= i && parent_[j] <= j);
    return i != j;
  }

private:
  Index shorten(Index i) {
    while(parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  Uninitialized_vector<Index> parent_;
};

/// for each vertex the smallest one of its connected component. Ranges of vertices are joined each
/// on its own; as they are pieces of a space-filling curve, few edges lead from one to another.
inline Uninitialized_vector<Index> smallest_in_component(Execution execution,
                                                         const Flat_mesh& mesh) {
  constexpr std::size_t grain = std::size_t(1) << 16;
  using Edge = std::pair<Index, Index>;
  const std::size_t n = mesh.number_of_vertices();
  Sets_of_indices sets(n);
  const auto join_range = [&](std::size_t begin, std::size_t end) {
    std::vector<Edge> edges_out;
    for(Index v = static_cast<Index>(begin); v < end; ++v)
      for(Index u : mesh.ring(v))
        if(u < begin)
          edges_out.emplace_back(u, v);
        else if(u < v)
          sets.unite(u, v);
    return edges_out;
  };
  for(const auto& [u, v] : collect<Edge>(execution, n, join_range, grain))
    sets.unite(u, v);
  Uninitialized_vector<Index> smallest(n);
  execution.for_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
    for(Index v = static_cast<Index>(begin); v < end; ++v) {
      const Index parent = sets.parent(v);
      CGAL_assertion(parent <= v);
      smallest[v] = parent == v ? v : parent < begin ? sets.find(parent) : smallest[parent];
    }
  });
  return smallest;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_SURFACE_COMPONENTS_H
