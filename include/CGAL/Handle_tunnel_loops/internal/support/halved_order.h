// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_HALVED_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_HALVED_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// One of many things, and where it is; all are moved together, which is what memory is fast at.
struct Placed_number
{
  std::array<double, 3> corner;
  Index number;
};

/// puts the smaller half of places along the axis on which they extend farthest before the others;
/// of those that are equal, the smaller numbers. What is empty has infinite corners.
template <typename Iterator> void halve(Iterator begin, Iterator middle, Iterator end) {
  Box<3> extent = Box<3>::empty();
  for(Iterator i = begin; i != end; ++i)
    extent.extend({i->corner, i->corner});
  std::size_t axis = 0;
  for(std::size_t d = 1; d < 3; ++d)
    if(extent.high[d] - extent.low[d] > extent.high[axis] - extent.low[axis])
      axis = d;
  std::nth_element(begin, middle, end, [&](const Placed_number& a, const Placed_number& b) {
    return std::tie(a.corner[axis], a.number) < std::tie(b.corner[axis], b.number);
  });
}

/// the numbers 0 .. n - 1 of things in an order in which those near each other follow each other;
/// `box(i)` is the box of the i-th. They are halved again and again, until \p group_size are left,
/// where they extend farthest, so that one far away makes no neighbours of others that are none;
/// these stand by their numbers.
template <std::size_t group_size, typename Function>
std::vector<Index> halved_order(Execution execution, std::size_t n, const Function& box) {
  std::vector<Placed_number> places(n);
  for_each_index(execution, n, [&](std::size_t i) {
    places[i] = {box(static_cast<Index>(i)).low, static_cast<Index>(i)};
  });
  for(std::size_t parts = 1; parts * group_size < n; parts *= 2)
    for_each_index(
        execution, parts,
        [&](std::size_t i) {
          const auto at = [&](std::size_t part) { return places.begin() + part * n / parts / 2; };
          halve(at(2 * i), at(2 * i + 1), at(2 * i + 2));
        },
        1);
  std::vector<Index> order(n);
  for_each_index(execution, n, [&](std::size_t i) { order[i] = places[i].number; });
  // What is left of halving stands in the order that a library leaves.
  std::size_t groups = 1;
  while(groups * group_size < n)
    groups *= 2;
  for_each_index(execution, groups, [&](std::size_t i) {
    std::sort(order.begin() + i * n / groups, order.begin() + (i + 1) * n / groups);
  });
  return order;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_HALVED_ORDER_H
