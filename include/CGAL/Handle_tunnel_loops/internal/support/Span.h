// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SPAN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SPAN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An array that somebody else owns, in the memory of the host or of the device.
template <typename T> class Span
{
public:
  Span() = default;

  CGAL_HTL_HOST_DEVICE Span(T* data, std::size_t size)
      : data_(data)
      , size_(size) {}

  /// of what may be changed, where it need not be.
  template <typename U, typename = std::enable_if_t<std::is_same<const U, T>::value>>
  CGAL_HTL_HOST_DEVICE Span(const Span<U>& other)
      : data_(other.data())
      , size_(other.size()) {}

  CGAL_HTL_HOST_DEVICE T* data() const { return data_; }
  CGAL_HTL_HOST_DEVICE std::size_t size() const { return size_; }
  CGAL_HTL_HOST_DEVICE bool empty() const { return size_ == 0; }
  CGAL_HTL_HOST_DEVICE T& operator[](std::size_t i) const { return data_[i]; }
  CGAL_HTL_HOST_DEVICE T* begin() const { return data_; }
  CGAL_HTL_HOST_DEVICE T* end() const { return data_ + size_; }

private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

/// of all of a vector.
template <typename T, typename Allocator>
Span<const T> span_of(const std::vector<T, Allocator>& values) {
  return {values.data(), values.size()};
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SPAN_H
