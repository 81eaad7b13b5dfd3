// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_TREE_OF_ARCS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_TREE_OF_ARCS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A tree of arcs of a graph, those of large parts first. Each other arc closes a cycle with it.
class Tree_of_arcs
{
public:
  Tree_of_arcs(const Part_balls& part_balls, const Ways_of_arcs& drawn)
      : drawn_(drawn)
      , has_(drawn.graph.arcs.size(), 0) {
    std::vector<Index> order(has_.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return part_balls.number(a) > part_balls.number(b); });
    Sets_of_indices sets(drawn.graph.vertex_of_node.size());
    for(const Index arc : order) {
      const auto [lower, upper] = drawn.graph.arcs[arc];
      has_[arc] = sets.find(lower) != sets.find(upper);
      sets.unite(lower, upper);
    }
  }

  bool has(Index arc) const { return has_[arc] != 0; }

  /// by node, the sum of what `value(node, arc)` of the arcs is that lead there from a root.
  template <typename Value, typename ValueOf, typename Sum>
  std::vector<Value> sums_at_nodes(const ValueOf& value, const Sum& sum) const {
    std::vector<Value> sums(drawn_.graph.vertex_of_node.size());
    std::vector<char> is_reached(sums.size(), 0);
    for(Index root = 0; root < sums.size(); ++root) {
      if(is_reached[root] != 0)
        continue;
      is_reached[root] = 1;
      std::vector<Index> reached = {root};
      for(std::size_t i = 0; i < reached.size(); ++i)
        for(const Index arc : drawn_.arcs_at[reached[i]]) {
          const auto [lower, upper] = drawn_.graph.arcs[arc];
          const Index other = lower == reached[i] ? upper : lower;
          if(!has(arc) || is_reached[other] != 0)
            continue;
          is_reached[other] = 1;
          sums[other] = sum(sums[reached[i]], value(reached[i], arc));
          reached.push_back(other);
        }
    }
    return sums;
  }

private:
  const Ways_of_arcs& drawn_;
  std::vector<char> has_; // by arc
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_TREE_OF_ARCS_H
