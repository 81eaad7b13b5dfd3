// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_ATOMICS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_ATOMICS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#if defined(__CUDACC__)
#include <cuda/atomic>
#elif __cplusplus >= 202002L && __has_include(<version>)
#include <version>
#endif

#if defined(__cpp_lib_atomic_ref)
#include <atomic>
#elif !defined(__CUDACC__)
#include <boost/atomic/atomic_ref.hpp>
#endif

#include <cstdint>
#include <functional>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// \file atomics.h
/// What threads do to common memory between two barriers. All of it is relaxed: only the barriers
/// order anything. (Boost uses the compiler's own functions, which the thread sanitizer sees
/// through.)

#if defined(__CUDACC__)
template <typename T> using Atomic_ref = cuda::atomic_ref<T, cuda::thread_scope_device>;
constexpr cuda::memory_order relaxed = cuda::memory_order_relaxed;
#elif defined(__cpp_lib_atomic_ref)
template <typename T> using Atomic_ref = std::atomic_ref<T>;
constexpr std::memory_order relaxed = std::memory_order_relaxed;
#else
template <typename T> using Atomic_ref = boost::atomic_ref<T>;
constexpr boost::memory_order relaxed = boost::memory_order_relaxed;
#endif

/// reads what another thread may be writing; the old value is as good as the new one.
template <typename T> CGAL_HTL_HOST_DEVICE T racy_load(const T& x) {
  return Atomic_ref<T>(const_cast<T&>(x)).load(relaxed);
}

/// writes what other threads may be reading, or writing the same value to.
template <typename T> CGAL_HTL_HOST_DEVICE void racy_store(T& x, T value) {
  Atomic_ref<T>(x).store(value, relaxed);
}

/// returns the old value, as all of these.
CGAL_HTL_HOST_DEVICE inline std::uint32_t fetch_or(std::uint32_t& x, std::uint32_t bits) {
  return Atomic_ref<std::uint32_t>(x).fetch_or(bits, relaxed);
}

template <typename T> CGAL_HTL_HOST_DEVICE T fetch_add(T& x, T summand) {
  return Atomic_ref<T>(x).fetch_add(summand, relaxed);
}

/// sets `x` to `value` if that comes before it, and returns what it was.
template <typename Before>
inline std::uint32_t
exchange_if(std::uint32_t& x, std::uint32_t value, const Before& comes_before) {
  const Atomic_ref<std::uint32_t> atomic(x);
  std::uint32_t old = atomic.load(relaxed);
  while(comes_before(value, old) && !atomic.compare_exchange_weak(old, value, relaxed))
    ;
  return old;
}

CGAL_HTL_HOST_DEVICE inline std::uint32_t fetch_min(std::uint32_t& x, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  return Atomic_ref<std::uint32_t>(x).fetch_min(value, relaxed);
#else
  return exchange_if(x, value, std::less<>());
#endif
}

CGAL_HTL_HOST_DEVICE inline std::uint32_t fetch_max(std::uint32_t& x, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  return Atomic_ref<std::uint32_t>(x).fetch_max(value, relaxed);
#else
  return exchange_if(x, value, std::greater<>());
#endif
}

CGAL_HTL_HOST_DEVICE inline std::uint32_t
compare_and_swap(std::uint32_t& x, std::uint32_t expected, std::uint32_t value) {
  Atomic_ref<std::uint32_t>(x).compare_exchange_strong(expected, value, relaxed);
  return expected;
}

/// a place at the end of a list that the counter is the size of. The threads of a warp that come
/// here together ask once.
CGAL_HTL_HOST_DEVICE inline std::uint32_t next_place(std::uint32_t& size) {
#ifdef __CUDA_ARCH__
  const unsigned here = __activemask();
  unsigned before;
  asm("mov.u32 %0, %%lanemask_lt;" : "=r"(before));
  const int leader = __ffs(static_cast<int>(here)) - 1;
  std::uint32_t first = 0;
  if((here & before) == 0)
    first = fetch_add(size, static_cast<std::uint32_t>(__popc(here)));
  return __shfl_sync(here, first, leader) + static_cast<std::uint32_t>(__popc(here & before));
#else
  return fetch_add(size, std::uint32_t(1));
#endif
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_ATOMICS_H
