// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_RUN_STEPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_RUN_STEPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/host_device.h>

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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_RUN_STEPS_H
