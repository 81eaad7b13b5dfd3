// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_EXECUTION_STEPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_EXECUTION_STEPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
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

#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

// ---- what threads do to common memory between two barriers

// All of it is relaxed: only the barriers order anything. (Boost uses the compiler's own functions,
// which the thread sanitizer sees through.)

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

// ---- programs of many steps

/*!
What each of the threads does that run a program of many steps together, from a memory of its own
(`Program::State`) that is the same in all of them: whether there is a next step follows from
counters that nobody changes any more, so all come to the same answer and meet at the same barriers.
One barrier a step, no host in between.

A program provides:
 - `State load()`, `void store(State)`: where an earlier run ended, and where this one does;
 - `bool begin_step(State&)`: whether there is a step to make;
 - `void clear_ahead(State)`: for one thread, readies the counters of later steps;
 - `Index size(State)` and `operator()(Index i, State)`: the items of the step, in any order;
 - `void end_step(State&)`: after the barrier.
*/
template <typename Program, typename Threads>
CGAL_HTL_HOST_DEVICE void run_steps(const Program& program, Threads& threads) {
  typename Program::State state = program.load();
  while(program.begin_step(state)) {
    if(threads.is_first())
      program.clear_ahead(state);
    threads.for_each(program.size(state), program, state);
    threads.wait();
    program.end_step(state);
  }
  threads.wait(); // until all have loaded, should there have been no step
  if(threads.is_first())
    program.store(state);
}

/// What the programs for `run_steps()` have in common that go on until a step changes nothing.
class Rounds
{
public:
  /// `changed` has three numbers, all of them zero.
  explicit Rounds(const Span<std::uint32_t>& changed)
      : changed_(changed) {}

  struct State
  {
    Index step;
    bool goes_on;
  };

  CGAL_HTL_HOST_DEVICE State load() const { return {0, true}; }
  CGAL_HTL_HOST_DEVICE void store(const State&) const {}

  CGAL_HTL_HOST_DEVICE bool begin_step(State& state) const {
    if(!state.goes_on)
      return false;
    ++state.step;
    return true;
  }
  CGAL_HTL_HOST_DEVICE void clear_ahead(const State& state) const {
    changed_[(state.step + 1) % 3] = 0;
  }
  CGAL_HTL_HOST_DEVICE void end_step(State& state) const {
    state.goes_on = changed_[state.step % 3] != 0;
  }

protected:
  CGAL_HTL_HOST_DEVICE void note_change(const State& state) const {
    racy_store(changed_[state.step % 3], std::uint32_t(1));
  }

private:
  Span<std::uint32_t> changed_;
};

// ---- what is often done with the memory of an executor

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

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_EXECUTION_STEPS_H
