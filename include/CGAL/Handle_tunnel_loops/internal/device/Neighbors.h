// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_NEIGHBORS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_NEIGHBORS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Field.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// \file Neighbors.h
/// What a step wants of the neighbours of a cell, in two ways: the mean of their values, the
/// earliest of them, and to have them in the band.

/// The neighbours of a cell that has more of them than a stencil, or walls beside it: one after the
/// other.
template <typename Region> class Neighbors_in_turn
{
public:
  CGAL_HTL_HOST_DEVICE Neighbors_in_turn(const Field<Region>& field, const Located_cell& cell)
      : field_(field)
      , cell_(cell) {}

  CGAL_HTL_HOST_DEVICE float mean(const Span<float>& value) const {
    float sum = 0.f;
    Index number = 0;
    field_.for_each_neighbor(cell_, [&](Index, Index u) {
      sum += u == no_index ? 0.f : value[u];
      ++number;
    });
    return sum / static_cast<float>(number);
  }

  /// the one with the least arrival key below the given one; `no_index` if there is none.
  CGAL_HTL_HOST_DEVICE Index earliest(std::uint64_t earliest_key) const {
    Index found = no_index;
    field_.for_each_neighbor(cell_, [&](Index v, Index u) {
      if(u == no_index)
        return;
      const std::uint64_t key = arrival_key(field_.time(u), v);
      if(key < earliest_key) {
        earliest_key = key;
        found = u;
      }
    });
    return found;
  }

  CGAL_HTL_HOST_DEVICE void activate(Time step) const { field_.activate_neighbors(cell_, step); }

private:
  const Field<Region>& field_;
  Located_cell cell_;
};

/// The neighbours of any other cell, all at once: a thread waits for the memory once, and not for
/// each neighbour.
template <typename Region> class Neighbors_at_once
{
public:
  CGAL_HTL_HOST_DEVICE
  Neighbors_at_once(const Field<Region>& field, const Located_cell& cell, const Ring& ring)
      : field_(field)
      , cell_(cell)
      , size_(ring.size()) {
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      vertices_[i] = i < size_ ? ring[i] : no_index;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      cells_[i] = i < size_ ? field.region().find(cell, vertices_[i]) : no_index;
  }

  CGAL_HTL_HOST_DEVICE float mean(const Span<float>& value) const {
    return stencil_mean(1.f / static_cast<float>(size_),
                        [&](Index i) { return cells_[i] == no_index ? 0.f : value[cells_[i]]; });
  }

  CGAL_HTL_HOST_DEVICE Index earliest(std::uint64_t earliest_key) const {
    Time times[stencil_width];
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      times[i] = cells_[i] == no_index ? never : field_.time(cells_[i]);
    Index found = no_index;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i) {
      const std::uint64_t key = arrival_key(times[i], vertices_[i]);
      const bool is_earlier = key < earliest_key;
      earliest_key = is_earlier ? key : earliest_key;
      found = is_earlier ? cells_[i] : found;
    }
    return found;
  }

  CGAL_HTL_HOST_DEVICE void activate(Time step) const {
    Index cells[stencil_width];
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      cells[i] = i < size_ && cells_[i] == no_index ? field_.region().insert(cell_, vertices_[i])
                                                    : cells_[i];
    field_.activate(cells, vertices_, cell_.pass, step);
  }

private:
  const Field<Region>& field_;
  Located_cell cell_;
  Index size_;
  Index vertices_[stencil_width], cells_[stencil_width]; // `no_index` beyond the last
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_NEIGHBORS_H
