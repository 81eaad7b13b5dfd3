// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_BUFFERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_BUFFERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// \file buffers.h
/// What is often done with the memory of an executor.

/// memory with the same value everywhere.
template <typename Executor, typename T>
typename Executor::template Buffer<T> filled(Executor& executor, std::size_t size, const T& value) {
  auto buffer = executor.template make<T>(size);
  executor.fill(buffer.span(), value);
  return buffer;
}

/// a copy, in the memory of the executor, of an array of the host.
template <typename Executor, typename T>
typename Executor::template Buffer<T>
uploaded(Executor& executor, const T* data, std::size_t size) {
  auto buffer = executor.template make<T>(size);
  executor.upload(buffer.span(), data);
  return buffer;
}

template <typename Executor, typename T>
typename Executor::template Buffer<T> uploaded(Executor& executor, const std::vector<T>& values) {
  return uploaded(executor, values.data(), values.size());
}

/// a copy on the host; what was asked for before is done then.
template <typename Executor, typename Buffer>
auto downloaded(Executor& executor, const Buffer& buffer) {
  std::vector<std::decay_t<decltype(buffer.span()[0])>> values(buffer.span().size());
  executor.download(values.data(), buffer.span());
  return values;
}

/// where each of several ranges of given sizes begins, and where the last one ends.
template <typename T> std::vector<T> begins_of(const std::vector<T>& sizes) {
  std::vector<T> begins(1, 0);
  for(T size : sizes)
    begins.push_back(begins.back() + size);
  return begins;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_BUFFERS_H
