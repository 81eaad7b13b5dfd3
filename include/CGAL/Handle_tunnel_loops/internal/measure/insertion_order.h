// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_INSERTION_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_INSERTION_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/halved_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the numbers of points in a biased randomized insertion order (Amenta, Choi, and Rote 2003): in
/// rounds at random, each about eight times as large as all before it; in a round, those near each
/// other follow each other. It is the same with every standard library, which that of
/// `CGAL::spatial_sort()` is not.
inline std::vector<Index> insertion_order(Execution execution, Span<const Vector> points) {
  constexpr std::size_t most_rounds = 8;
  std::array<std::vector<Index>, most_rounds> rounds; // the last one first
  std::mt19937 random;
  for(Index i = 0; i < points.size(); ++i) {
    std::size_t round = 0;
    for(auto bits = random(); round + 1 < most_rounds && bits % 8 == 0; bits /= 8)
      ++round;
    rounds[round].push_back(i);
  }
  std::vector<Index> order;
  order.reserve(points.size());
  for(std::size_t round = most_rounds; round-- > 0;) {
    const std::vector<Index>& chosen = rounds[round];
    const auto box = [&](Index i) { return Box<3>{points[chosen[i]], points[chosen[i]]}; };
    for(const Index i : halved_order<4>(execution, chosen.size(), box))
      order.push_back(chosen[i]);
  }
  return order;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_INSERTION_ORDER_H
