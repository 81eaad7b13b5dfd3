// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SPACE_FILLING_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SPACE_FILLING_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/parallel.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// spreads the ten low bits of `x` to every third bit.
inline std::uint64_t every_third_bit(std::uint64_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

/// the numbers 0 .. n - 1 of points in the unit box, sorted along a Morton curve. Meshes come in
/// any order; a field that walks them in file order waits for memory.
template <typename Execution>
std::vector<Index> space_filling_order(Execution execution, const std::vector<Vector>& points) {
  constexpr double cells = 1023.;
  std::vector<std::uint64_t> keys(points.size());
  for_each_index(execution, points.size(), [&](std::size_t i) {
    const Vector& p = points[i];
    std::uint64_t key = 0;
    for(int d = 0; d < 3; ++d)
      key |= every_third_bit(static_cast<std::uint64_t>(p[d] * cells)) << d;
    keys[i] = key << 32 | i;
  });
  boost::sort::spreadsort::integer_sort(keys.begin(), keys.end());

  std::vector<Index> order(points.size());
  for_each_index(execution, keys.size(),
                 [&](std::size_t i) { order[i] = static_cast<Index>(keys[i]); });
  return order;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SPACE_FILLING_ORDER_H
