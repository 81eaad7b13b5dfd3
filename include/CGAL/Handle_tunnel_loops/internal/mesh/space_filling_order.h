// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_SPACE_FILLING_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_SPACE_FILLING_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// spreads the ten low bits of `x` to every third bit.
inline std::uint32_t every_third_bit(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

/// the numbers 0 .. n - 1 of points `point(i)` in the unit box, sorted along a Morton curve, those
/// in one cell by their numbers. Meshes come in any order; a field that walks them in file order
/// waits for memory.
template <typename Point>
std::vector<Index> space_filling_order(Execution execution, std::size_t n, const Point& point) {
  struct Numbered_cell
  {
    std::uint32_t cell;
    Index number;
  };
  constexpr double cells = 1023.;
  Uninitialized_vector<Numbered_cell> numbered(n);
  for_each_index(execution, n, [&](std::size_t i) {
    const Vector p = point(i);
    std::uint32_t cell = 0;
    for(int d = 0; d < 3; ++d) {
      CGAL_precondition(p[d] >= 0. && p[d] <= 1.);
      cell |= every_third_bit(static_cast<std::uint32_t>(p[d] * cells)) << d;
    }
    numbered[i] = {cell, static_cast<Index>(i)};
  });
  radix_sort<30>(execution, numbered, [](const Numbered_cell& c) { return c.cell; });

  std::vector<Index> order(n);
  for_each_index(execution, n, [&](std::size_t i) { order[i] = numbered[i].number; });
  return order;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_SPACE_FILLING_ORDER_H
