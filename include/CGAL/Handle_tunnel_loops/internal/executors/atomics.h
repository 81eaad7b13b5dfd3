// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_ATOMICS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_ATOMICS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/host_device.h>

#ifdef __CUDACC__
#include <cuda/atomic>
#endif

#include <cstdint>
#include <functional>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// \file atomics.h
/// What threads do to common memory between two barriers. All of it is relaxed: only the barriers
/// order anything. (The compiler's own functions are what the thread sanitizer sees through.)

#ifdef __CUDACC__
template <typename T> using Atomic_on_device = cuda::atomic_ref<T, cuda::thread_scope_device>;
#endif

/// reads what another thread may be writing; the old value is as good as the new one.
template <typename T> CGAL_HTL_HOST_DEVICE T racy_load(const T& x) {
#ifdef __CUDA_ARCH__
  return Atomic_on_device<T>(const_cast<T&>(x)).load(cuda::memory_order_relaxed);
#else
  return __atomic_load_n(&x, __ATOMIC_RELAXED);
#endif
}

/// writes what other threads may be reading, or writing the same value to.
template <typename T> CGAL_HTL_HOST_DEVICE void racy_store(T& x, T value) {
#ifdef __CUDA_ARCH__
  Atomic_on_device<T>(x).store(value, cuda::memory_order_relaxed);
#else
  __atomic_store_n(&x, value, __ATOMIC_RELAXED);
#endif
}

/// returns the old value, as all of these.
CGAL_HTL_HOST_DEVICE inline std::uint32_t fetch_or(std::uint32_t& x, std::uint32_t bits) {
#ifdef __CUDA_ARCH__
  return Atomic_on_device<std::uint32_t>(x).fetch_or(bits, cuda::memory_order_relaxed);
#else
  return __atomic_fetch_or(&x, bits, __ATOMIC_RELAXED);
#endif
}

template <typename T> CGAL_HTL_HOST_DEVICE T fetch_add(T& x, T summand) {
#ifdef __CUDA_ARCH__
  return Atomic_on_device<T>(x).fetch_add(summand, cuda::memory_order_relaxed);
#else
  return __atomic_fetch_add(&x, summand, __ATOMIC_RELAXED);
#endif
}

/// sets `x` to `value` if that comes before it, and returns what it was.
template <typename Before>
inline std::uint32_t
exchange_if(std::uint32_t& x, std::uint32_t value, const Before& comes_before) {
  std::uint32_t old = __atomic_load_n(&x, __ATOMIC_RELAXED);
  while(comes_before(value, old) &&
        !__atomic_compare_exchange_n(&x, &old, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
    ;
  return old;
}

CGAL_HTL_HOST_DEVICE inline std::uint32_t fetch_min(std::uint32_t& x, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  return Atomic_on_device<std::uint32_t>(x).fetch_min(value, cuda::memory_order_relaxed);
#else
  return exchange_if(x, value, std::less<>());
#endif
}

CGAL_HTL_HOST_DEVICE inline std::uint32_t fetch_max(std::uint32_t& x, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  return Atomic_on_device<std::uint32_t>(x).fetch_max(value, cuda::memory_order_relaxed);
#else
  return exchange_if(x, value, std::greater<>());
#endif
}

CGAL_HTL_HOST_DEVICE inline std::uint32_t
compare_and_swap(std::uint32_t& x, std::uint32_t expected, std::uint32_t value) {
#ifdef __CUDA_ARCH__
  Atomic_on_device<std::uint32_t>(x).compare_exchange_strong(expected, value,
                                                             cuda::memory_order_relaxed);
  return expected;
#else
  __atomic_compare_exchange_n(&x, &expected, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
  return expected;
#endif
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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_ATOMICS_H
