// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ARRAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ARRAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The number of a vertex, a loop, a cell.
using Index = std::uint32_t;
constexpr Index no_index = (std::numeric_limits<Index>::max)();

/// Halfedges have indices, too: no mesh has more than 1.43 billion faces.
constexpr std::size_t most_halfedges = no_index - 1;

/// As many neighbours as rows of a fixed length have room for: valences vary at random, and a
/// mispredicted branch costs as much as the work itself.
constexpr Index stencil_width = 8;

/// A vertex of more neighbours than these may have a great part of all others: what is asked of it
/// again and again is kept, as it must not take as long as there are neighbours each time.
constexpr Index many_neighbors = 64;

/// A vertex of more neighbours than these is not gone around for every loop that passes it.
constexpr Index very_many_neighbors = 1000;

/// the same number for both directions of an edge, by the numbers of its ends.
constexpr std::uint64_t edge_key(std::uint64_t u, std::uint64_t v) {
  return u < v ? u << 32 | v : v << 32 | u;
}

/// Leaves elements that are not given a value without one.
template <typename T> struct Uninitialized_allocator : std::allocator<T>
{
  template <typename U> struct rebind
  {
    using other = Uninitialized_allocator<U>;
  };

  Uninitialized_allocator() = default;
  template <typename U> Uninitialized_allocator(const Uninitialized_allocator<U>&) noexcept {}

  template <typename U> void construct(U* place) { ::new(static_cast<void*>(place)) U; }
  template <typename U, typename... Values> void construct(U* place, Values&&... values) {
    ::new(static_cast<void*>(place)) U(std::forward<Values>(values)...);
  }
};

/// A vector whose `resize()` touches no memory: large arrays are filled by several threads, and the
/// first touch, for which the system has to find and clear the memory, is then theirs too.
template <typename T> using Uninitialized_vector = std::vector<T, Uninitialized_allocator<T>>;

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ARRAYS_H
