// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_BULGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_BULGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds bulges of a solid: balls that one comes to from a skeleton, or from larger ones, only by
places that are much narrower, as to a wheel on its axle.

Balls are joined in the order of their radii, the largest first. Where two that are joined have
become one, what is between them is as narrow there as the last.
*/
class Bulges
{
public:
  /// \p starts are balls of the skeleton.
  Bulges(const Ball_graph& graph, const std::vector<Index>& starts)
      : graph_(graph)
      , has_start_(graph.balls.size(), 0)
      , top_(graph.balls.size(), no_index)
      , sets_(graph.balls.size()) {
    for(Index b : starts)
      has_start_[b] = 1;
    std::vector<Index> order(graph.balls.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return radius(a) > radius(b); });
    for(Index b : order)
      if(graph.is_inlet[b] == 0) {
        top_[b] = b;
        graph.for_each_beside(b, [&](Index other, Index) {
          if(top_[other] != no_index)
            join(b, other);
        });
      }
  }

  /// the largest ball of each.
  const std::vector<Index>& balls() const { return balls_; }

private:
  double radius(Index ball) const { return graph_.balls[ball].radius; }

  void join(Index narrow, Index other) {
    const Index a = sets_.find(narrow), b = sets_.find(other);
    if(a == b)
      return;
    const bool is_a_higher =
        has_start_[a] != has_start_[b] ? has_start_[a] != 0 : radius(top_[a]) > radius(top_[b]);
    const Index higher = is_a_higher ? a : b, lower = is_a_higher ? b : a;
    constexpr double ratio = 1.5;
    if(has_start_[lower] == 0 && radius(top_[lower]) > ratio * radius(narrow))
      balls_.push_back(top_[lower]);
    const Index top = top_[higher];
    const char has_start = has_start_[higher];
    sets_.unite(a, b);
    top_[sets_.find(a)] = top;
    has_start_[sets_.find(a)] = has_start;
  }

  const Ball_graph& graph_;
  std::vector<char> has_start_; // by set
  std::vector<Index> top_;      // by set, the largest ball
  Sets_of_indices sets_;
  std::vector<Index> balls_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_BULGES_H
