// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_WALL_ARRAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_WALL_ARRAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// The arrays of a `Crossing_index`, and which of its loops are walls to the pass of a loop: those
/// in a set of type `Loop_set`, made from the number of the loop.
template <typename Loop_set> struct Wall_arrays
{
  Span<const Index> begins;
  Span<const Crossing_entry> entries;

  CGAL_HTL_HOST_DEVICE bool is_wall(Index loop, Index u, Index v) const {
    bool result = false;
    for_each_wall(loop, u, [&](Index other) { result = result || other == v; });
    return result;
  }

  /// a bit for each of some neighbours of `u`: whether there is a wall between.
  CGAL_HTL_HOST_DEVICE std::uint32_t
  walls_among(const Index (&neighbors)[stencil_width], Index loop, Index u) const {
    std::uint32_t bits = 0;
    for_each_wall(loop, u, [&](Index other) {
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        bits |= neighbors[i] == other ? 1u << i : 0u;
    });
    return bits;
  }

  /// whether there may be walls beside `v`, for a field whose sources are the ends of the crossings
  /// of a loop. Where it is the only wall, there are walls beside its sources.
  CGAL_HTL_HOST_DEVICE bool may_be_beside(Index v, bool is_source) const {
    return Loop_set::is_one ? is_source : begins[v] != begins[v + 1];
  }

  /// calls `f` for each other loop that is a wall between `u` and `v`.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void
  for_each_other_wall(Index loop, Index u, Index v, const Function& f) const {
    const Loop_set barred = {loop};
    CGAL_HTL_NO_UNROLL
    for(Index i = begins[u]; i < begins[u + 1]; ++i)
      if(entries[i].other == v && entries[i].loop != loop && barred.contains(entries[i].loop))
        f(entries[i].loop);
  }

  /// how often loop `loop` is crossed on the way from `u` to `v`, an edge or a point.
  CGAL_HTL_HOST_DEVICE int crossings(Index loop, Index u, Index v) const {
    int sum = 0;
    CGAL_HTL_NO_UNROLL
    for(Index i = begins[u]; i < begins[u + 1]; ++i)
      if(entries[i].other == v && entries[i].loop == loop)
        sum += entries[i].sign;
    return sum;
  }

private:
  // Calls `f` for the other ends of the edges of `u` on which there are walls. The entries are
  // sorted by loop.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void for_each_wall(Index loop, Index u, const Function& f) const {
    const Loop_set barred = {loop};
    const Index begin = begins[u];
    CGAL_HTL_NO_UNROLL
    for(Index i = begins[u + 1]; i > begin && !barred.are_all_after(entries[i - 1].loop); --i)
      if(barred.contains(entries[i - 1].loop))
        f(entries[i - 1].other);
  }
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_WALL_ARRAYS_H
