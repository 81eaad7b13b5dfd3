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

#include <CGAL/Handle_tunnel_loops/internal/field/atomics.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_EXECUTION_STEPS_H
