// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_STEPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_STEPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Neighbors.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// The explicit Euler steps of all passes in a region, as a program for `run_steps()`: value for
/// value and time for time what `Narrow_band` computes.
template <typename Region> class Field_steps
{
public:
  using State = Field_state;

  /// \p enough is the number of cells after which nothing is left to reach, and \p pause the step
  /// after which the host wants to see what there is.
  Field_steps(const Field<Region>& field, const Step_coefficients& k, Index enough, Time pause)
      : field_(field)
      , coefficients_(k)
      , spark_(k.penalty / k.diffusion)
      , enough_(enough)
      , pause_(pause) {}

  CGAL_HTL_HOST_DEVICE State load() const { return arrays().control->state; }
  CGAL_HTL_HOST_DEVICE void store(const State& state) const { arrays().control->state = state; }

  CGAL_HTL_HOST_DEVICE bool begin_step(State& state) const {
    state.band_size = arrays().control->counters.band_size[(state.step + 1) % 3];
    if(state.band_size == 0 || state.number_of_reached >= enough_ || state.step == pause_)
      return false;
    ++state.step;
    return true;
  }

  CGAL_HTL_HOST_DEVICE void clear_ahead(const State& state) const {
    arrays().control->counters.band_size[(state.step + 2) % 3] = 0;
    arrays().control->counters.number_of_arrivals[(state.step + 1) % 3] = 0;
  }

  CGAL_HTL_HOST_DEVICE Index size(const State& state) const {
    return number_of_passes() + state.band_size;
  }

  CGAL_HTL_HOST_DEVICE void end_step(State& state) const {
    state.number_of_reached += arrays().control->counters.number_of_arrivals[state.step % 3];
    state.number_of_updates += state.band_size;
  }

  CGAL_HTL_HOST_DEVICE void operator()(Index i, const State& state) const {
    if(i < number_of_passes())
      update_pass(i, state.step);
    else
      update(arrays().band[state.step % 2][i - number_of_passes()], state.step);
  }

private:
  CGAL_HTL_HOST_DEVICE const Field_arrays& arrays() const { return field_.arrays(); }
  CGAL_HTL_HOST_DEVICE const Pass_arrays& passes() const { return field_.arrays().passes; }
  CGAL_HTL_HOST_DEVICE const Region& region() const { return field_.region(); }
  CGAL_HTL_HOST_DEVICE Index number_of_passes() const {
    return static_cast<Index>(passes().last_step.size());
  }

  // What a step does to its pass, and what it is: the same for all cells of the pass.
  struct Phase
  {
    bool is_over, is_push;
  };

  CGAL_HTL_HOST_DEVICE Phase phase(Index pass, Time step) const {
    const Time idle = step - passes().progress[(step + 1) % 2][pass];
    const bool is_push = idle == patience + 2;
    return {idle > patience + 2 || step - is_push > racy_load(passes().last_step[pass]), is_push};
  }

  // When a pass last came on is written to the one array and read from the other, in turns. That a
  // pass has made enough updates matters from the next step on.
  CGAL_HTL_HOST_DEVICE void update_pass(Index pass, Time step) const {
    fetch_max(passes().progress[step % 2][pass], passes().progress[(step + 1) % 2][pass]);
    if(passes().band_size.empty())
      return;
    if(region().is_starved(pass))
      return racy_store(passes().last_step[pass], Time(0));
    Index& change = passes().band_change[(step + 2) % 3][pass];
    passes().band_size[pass] += change;
    change = 0;
    const Phase now = phase(pass, step);
    if(now.is_push && step - 1 == passes().last_step[pass])
      racy_store(passes().last_step[pass], step); // a push belongs to the step before it
    if(now.is_over || now.is_push)
      return;
    passes().updates[pass] += passes().band_size[pass];
    if(passes().updates[pass] >= passes().enough_updates)
      racy_store(passes().last_step[pass], step);
  }

  CGAL_HTL_HOST_DEVICE void note_arrival(Index cell, Index pass, Time step) const {
    if(racy_load(passes().progress[step % 2][pass]) != step)
      fetch_max(passes().progress[step % 2][pass], step);
    next_place(arrays().control->counters.number_of_arrivals[step % 3]);
    if(!arrays().reached.empty())
      arrays().reached[next_place(arrays().control->counters.reached_size)] = cell;
  }

  CGAL_HTL_HOST_DEVICE void arrive(Index cell, Time time, Index from) const {
    if(field_.side(from) != 0)
      fetch_or(arrays().state[cell], cell_is_right);
    racy_store(arrays().time[cell], time);
  }

  // What is wanted of the memory is asked for before anything is decided.
  CGAL_HTL_HOST_DEVICE void update(Index cell, Time step) const {
    const float before = arrays().value[(step + 1) % 2][cell];
    const bool has_walls = field_.may_have_walls(cell);
    const Located_cell located = region().located(cell);
    const Ring ring = region().mesh().ring(located.vertex);
    const Phase now = phase(located.pass, step);
    if(now.is_over)
      return;
    const Banded banded = {cell, located.pass, before, now.is_push};
    if(before == 1.f) // it has left the band
      arrays().value[step % 2][cell] = before;
    else if(has_walls || ring.size() > stencil_width)
      advance(banded, Neighbors_in_turn<Region>(field_, located), step);
    else
      advance(banded, Neighbors_at_once<Region>(field_, located, ring), step);
  }

  // A cell of the band, and its value after the last step.
  struct Banded
  {
    Index cell, pass;
    float before;
    bool is_push;
  };

  template <typename Neighbors>
  CGAL_HTL_HOST_DEVICE void advance(const Banded& c, const Neighbors& neighbors, Time step) const {
    const float after = c.is_push ? pushed(c, neighbors, step) : settled(c, neighbors, step);
    arrays().value[step % 2][c.cell] = after;
    if(c.before <= spark_ && (c.is_push ? after == 1.f : after > spark_))
      neighbors.activate(step + 1);
    if(after == 1.f)
      field_.change_band_size(c.pass, step, -1);
    field_.append_to_band(c.cell, step + 1);
  }

  template <typename Neighbors>
  CGAL_HTL_HOST_DEVICE float settled(const Banded& c, const Neighbors& neighbors, Time step) const {
    const float mean = neighbors.mean(arrays().value[(step + 1) % 2]);
    const float after = stepped_value(c.before, mean, coefficients_);
    if(c.before >= front_threshold || after < front_threshold)
      return after;
    const Index earlier = neighbors.earliest(key_of_step(step));
    if(earlier == no_index)
      return just_below_threshold;
    arrive(c.cell, crossing_time(c.before, after, step), earlier);
    note_arrival(c.cell, c.pass, step);
    return after;
  }

  // Where a front has come to rest, all that it touches is declared reached.
  template <typename Neighbors>
  CGAL_HTL_HOST_DEVICE float pushed(const Banded& c, const Neighbors& neighbors, Time step) const {
    const Index earlier =
        field_.is_reached(c.cell) ? no_index : neighbors.earliest(key_of_step(step));
    if(earlier == no_index)
      return c.before;
    arrive(c.cell, step * ticks_per_step, earlier);
    note_arrival(c.cell, c.pass, step);
    return 1.f;
  }

  // Above the keys of what was reached in earlier steps.
  CGAL_HTL_HOST_DEVICE static std::uint64_t key_of_step(Time step) {
    return arrival_key((step - 1) * ticks_per_step, no_index);
  }

  Field<Region> field_;
  Step_coefficients coefficients_;
  float spark_; // a vertex stays at zero as long as all its neighbours are below this value
  Index enough_;
  Time pause_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_STEPS_H
