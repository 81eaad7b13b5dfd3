// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_NEIGHBORS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_NEIGHBORS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/kernels/Field.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/*!
The neighbours of a cell that no wall parts from it: what a step wants of them. They are loaded
eight at a time, so that a thread waits for the memory once and not for each of them, and the first
eight are kept.
*/
template <typename Domain> class Neighbors
{
  /// Some of the neighbours, and their cells; `no_index` beyond the last and behind walls, and for
  /// the cells of vertices where the field has not been.
  struct Some
  {
    Index vertices[stencil_width], cells[stencil_width];
  };

public:
  CGAL_HTL_HOST_DEVICE Neighbors(const Field<Domain>& field, const Located_cell& cell)
      : Neighbors(field,
                  cell,
                  field.domain().mesh().rows[cell.vertex],
                  field.domain().mesh().ring(cell.vertex),
                  field.may_have_walls(cell.cell)) {}

  /// the same where all that is asked for has been loaded before.
  CGAL_HTL_HOST_DEVICE Neighbors(const Field<Domain>& field,
                                 const Located_cell& cell,
                                 const Neighbor_row& row,
                                 const Ring& ring,
                                 bool has_walls)
      : field_(field)
      , cell_(cell)
      , ring_(ring)
      , has_walls_(has_walls) {
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      first_.vertices[i] = row.at[i];
    find_cells(first_);
  }

  /// calls `f` for each neighbour and its cell.
  template <typename Function> CGAL_HTL_HOST_DEVICE void for_each(const Function& f) const {
    for_each_eight([&](const Some& some) {
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        if(some.vertices[i] != no_index)
          f(some.vertices[i], some.cells[i]);
    });
  }

  /// in the order of summation that the host has, too.
  CGAL_HTL_HOST_DEVICE float mean(const Span<float>& value) const {
    const auto value_of = [&](Index cell) { return cell == no_index ? 0.f : value[cell]; };
    if(!has_walls_ && ring_.size() <= stencil_width)
      return stencil_mean(1.f / static_cast<float>(ring_.size()),
                          [&](Index i) { return value_of(first_.cells[i]); });
    float sum = 0.f;
    Index number = 0;
    for_each_eight([&](const Some& some) {
      float values[stencil_width];
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        values[i] = value_of(some.cells[i]);
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i) {
        sum += values[i];
        number += some.vertices[i] != no_index ? 1 : 0;
      }
    });
    return sum / static_cast<float>(number);
  }

  /// Where a front comes from.
  struct Earliest
  {
    std::uint64_t key;        ///< the least arrival key
    std::uint32_t is_right;   ///< of that neighbour: `cell_is_right` or zero
    bool has_left, has_right; ///< whether there are neighbours reached from the left, the right
  };

  /// the neighbour with the least arrival key of those below a given one, which `key` is else.
  CGAL_HTL_HOST_DEVICE Earliest earliest(std::uint64_t key) const {
    Earliest found = {key, 0, false, false};
    for_each_eight([&](const Some& some) {
      Time times[stencil_width];
      std::uint32_t sides[stencil_width];
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i) {
        times[i] = some.cells[i] == no_index ? never : field_.time(some.cells[i]);
        sides[i] = Domain::has_sides && some.cells[i] != no_index ? field_.side(some.cells[i]) : 0;
      }
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i) {
        const std::uint64_t other = arrival_key(times[i], some.vertices[i]);
        found.has_left = found.has_left || (other < key && sides[i] == 0);
        found.has_right = found.has_right || (other < key && sides[i] != 0);
        found.is_right = other < found.key ? sides[i] : found.is_right;
        found.key = other < found.key ? other : found.key;
      }
    });
    return found;
  }

  /// has all of them in the band from the next step on.
  CGAL_HTL_HOST_DEVICE void activate(const Field_state& now) const {
    for_each_eight([&](Some some) {
      field_.domain().insert(some.cells, some.vertices, cell_.pass);
      field_.activate(some.cells, some.vertices, cell_.pass, now);
    });
  }

private:
  CGAL_HTL_HOST_DEVICE void find_cells(Some& some) const {
    if(has_walls_) {
      const std::uint32_t walls = field_.domain().walls_among(some.vertices, cell_);
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        some.vertices[i] = (walls >> i & 1) != 0 ? no_index : some.vertices[i];
    }
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      some.cells[i] =
          some.vertices[i] == no_index ? no_index : field_.domain().find(cell_, some.vertices[i]);
  }

  template <typename Function> CGAL_HTL_HOST_DEVICE void for_each_eight(const Function& f) const {
    f(first_);
    CGAL_HTL_NO_UNROLL
    for(Index begin = stencil_width; begin < ring_.size(); begin += stencil_width) {
      Some some;
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        some.vertices[i] = begin + i < ring_.size() ? ring_[begin + i] : no_index;
      find_cells(some);
      f(some);
    }
  }

  const Field<Domain>& field_;
  Located_cell cell_;
  Ring ring_;
  bool has_walls_;
  Some first_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_NEIGHBORS_H
