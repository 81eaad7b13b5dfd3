// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_ROUNDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_ROUNDS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/executors/atomics.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EXECUTORS_ROUNDS_H
