// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_UNINITIALIZED_VECTOR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_UNINITIALIZED_VECTOR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_UNINITIALIZED_VECTOR_H
