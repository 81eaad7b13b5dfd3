// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_NAMED_FOREST_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_NAMED_FOREST_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Which nodes are joined by edges (union-find), and the sums of numbers, the names of edges, along
/// the ways between them. Who goes an edge the other way takes away its name.
class Named_forest
{
public:
  explicit Named_forest(std::size_t nodes)
      : root_(nodes)
      , name_to_root_(nodes, 0) {
    std::iota(root_.begin(), root_.end(), Index(0));
  }

  /// adds an edge. Returns the name of the cycle that it closes, if it does not join what is apart.
  std::optional<std::uint64_t> join(Index a, Index b, std::uint64_t name) {
    const auto [root_a, name_a] = find_root(a);
    const auto [root_b, name_b] = find_root(b);
    const std::uint64_t around = name_b + name - name_a; // from the root of b by b and a
    if(root_a == root_b)
      return around;
    // From the root of a by a and b to that of b: name_a is of the way from a to its root.
    const Index child = (std::max)(root_a, root_b);
    root_[child] = (std::min)(root_a, root_b);
    name_to_root_[child] = child == root_a ? around : 0 - around;
    return std::nullopt;
  }

private:
  // With the name of the way there. Halves the ways.
  std::pair<Index, std::uint64_t> find_root(Index v) {
    std::uint64_t name = 0;
    while(root_[v] != v) {
      const Index above = root_[v];
      if(root_[above] != above) {
        name_to_root_[v] += name_to_root_[above];
        root_[v] = root_[above];
      }
      name += name_to_root_[v];
      v = root_[v];
    }
    return {v, name};
  }

  std::vector<Index> root_;
  std::vector<std::uint64_t> name_to_root_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_NAMED_FOREST_H
