// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_FIELD_STEPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_FIELD_STEPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/kernels/Neighbors.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// The explicit Euler steps of all passes in a domain, as a program for `run_steps()`: value for
/// value and time for time what `Narrow_band` computes.
template <typename Domain> class Field_steps
{
public:
  using State = Field_state;

  /// When the host wants to see what there is: once so many cells are reached that nothing is left
  /// to reach, after a step, or after an earlier one if fronts have met.
  struct End
  {
    Index enough_reached;
    Time step, step_if_met;
  };

  Field_steps(const Field<Domain>& field, const Step_coefficients& k, const End& end)
      : field_(field)
      , coefficients_(k)
      , spark_(k.penalty / k.diffusion)
      , end_(end) {}

  CGAL_HTL_HOST_DEVICE State load() const {
    State state = arrays().control->state;
    state.has_met = 0;
    return state;
  }
  CGAL_HTL_HOST_DEVICE void store(const State& state) const { arrays().control->state = state; }

  CGAL_HTL_HOST_DEVICE bool begin_step(State& state) const {
    const Time last = state.step;
    state.next_list_size = state.first_free_place() + counters().added[last % 3].value;
    if(state.next_list_size == 0 || state.number_of_reached >= end_.enough_reached ||
       last == end_.step || (state.has_met != 0 && last >= end_.step_if_met))
      return false;
    ++state.step;
    state.list_size = state.next_list_size;
    if(is_end_of_list(last))
      state.number_of_dead = 0;
    return true;
  }

  CGAL_HTL_HOST_DEVICE void clear_ahead(const State& state) const {
    const Time next = (state.step + 1) % 3;
    counters().added[next].value = counters().left[next].value = 0;
    counters().arrivals[next].value = counters().meetings[next].value = 0;
  }

  CGAL_HTL_HOST_DEVICE Index size(const State& state) const {
    return number_of_passes() + state.list_size;
  }

  CGAL_HTL_HOST_DEVICE void end_step(State& state) const {
    const Time now = state.step % 3;
    state.number_of_updates += state.list_size - state.number_of_dead;
    state.number_of_dead += counters().left[now].value;
    state.number_of_reached += counters().arrivals[now].value;
    state.has_met |= counters().meetings[now].value;
  }

  CGAL_HTL_HOST_DEVICE void operator()(Index i, const State& now) const {
    if(i < number_of_passes())
      update_pass(i, now.step);
    else
      update(i - number_of_passes(), now);
  }

private:
  using Neighbors_of_cell = Neighbors<Domain>;
  using Earliest = typename Neighbors_of_cell::Earliest;

  CGAL_HTL_HOST_DEVICE const typename Field<Domain>::Arrays& arrays() const {
    return field_.arrays();
  }
  CGAL_HTL_HOST_DEVICE const Pass_arrays& passes() const { return field_.arrays().passes; }
  CGAL_HTL_HOST_DEVICE Step_counters& counters() const { return arrays().control->counters; }
  CGAL_HTL_HOST_DEVICE const Domain& domain() const { return field_.domain(); }
  CGAL_HTL_HOST_DEVICE Index number_of_passes() const {
    return static_cast<Index>(passes().last_step.size());
  }

  // What a step does to its pass, and what it is: the same for all cells of the pass.
  struct Phase
  {
    bool is_over, is_push;
  };

  CGAL_HTL_HOST_DEVICE Phase phase(Time progress, Time last_step, Time step) const {
    const Time idle = step - progress;
    const bool is_push = idle == coefficients_.patience + 2;
    return {idle > coefficients_.patience + 2 || step - is_push > last_step, is_push};
  }

  // When a pass last came on is written to the one array and read from the other, in turns. That a
  // pass has made enough updates matters from the next step on.
  CGAL_HTL_HOST_DEVICE void update_pass(Index pass, Time step) const {
    const Time progress = passes().progress[(step + 1) % 2][pass];
    fetch_max(passes().progress[step % 2][pass], progress);
    if(passes().band_size.empty())
      return;
    Time& last_step = passes().last_step[pass];
    Index& change = passes().band_change[(step + 2) % 3][pass];
    const Phase now = phase(progress, last_step, step);
    const Index band_size = passes().band_size[pass] + change;
    const std::uint64_t updates = passes().updates[pass] + band_size;
    passes().band_size[pass] = band_size;
    change = 0;
    if(domain().is_starved(pass))
      racy_store(last_step, Time(0));
    else if(now.is_push && step - 1 == last_step)
      racy_store(last_step, step); // a push belongs to the step before it
    else if(!now.is_over && !now.is_push) {
      passes().updates[pass] = updates;
      if(updates >= passes().enough_updates)
        racy_store(last_step, step);
    }
  }

  // What is wanted of the memory is asked for before anything is decided.
  CGAL_HTL_HOST_DEVICE void update(Index place, const State& now) const {
    typename Domain::Banded_cell& banded = arrays().band[list_of_step(now.step)][place];
    const Located_cell c = domain().located(banded);
    if(c.cell == no_index)
      return; // it has left the band
    const float before = arrays().value[(now.step + 1) % 2][c.cell];
    const Neighbor_row row = domain().mesh().rows[c.vertex];
    const Ring ring = domain().mesh().ring(c.vertex);
    const bool has_walls = field_.may_have_walls(c.cell);
    const Phase of_pass = phase(passes().progress[(now.step + 1) % 2][c.pass],
                                racy_load(passes().last_step[c.pass]), now.step);
    if(of_pass.is_over || before == 1.f) {
      if(!of_pass.is_over)
        arrays().value[now.step % 2][c.cell] = before;
      next_place(counters().left[now.step % 3].value);
      banded = Domain::banded({no_index, no_index, no_index});
      return;
    }
    if(is_end_of_list(now.step))
      field_.keep(c, now);
    const Neighbors_of_cell neighbors(field_, c, row, ring, has_walls);
    const float after = of_pass.is_push ? pushed(c, before, neighbors, now.step)
                                        : settled(c, before, neighbors, now.step);
    arrays().value[now.step % 2][c.cell] = after;
    if(before <= spark_ && (of_pass.is_push ? after == 1.f : after > spark_))
      neighbors.activate(now);
    if(after == 1.f)
      field_.change_band_size(c.pass, now.step, -1);
  }

  CGAL_HTL_HOST_DEVICE float settled(const Located_cell& c,
                                     float before,
                                     const Neighbors_of_cell& neighbors,
                                     Time step) const {
    const float mean = neighbors.mean(arrays().value[(step + 1) % 2]);
    const float after = stepped_value(before, mean, coefficients_);
    if(before >= front_threshold || after < front_threshold)
      return after;
    const Earliest earliest = neighbors.earliest(key_of_step(step));
    if(earliest.key == key_of_step(step))
      return just_below_threshold;
    arrive(c, crossing_time(before, after, step), earliest, step);
    return after;
  }

  // Where a front has come to rest, all that it touches is declared reached.
  CGAL_HTL_HOST_DEVICE float
  pushed(const Located_cell& c, float before, const Neighbors_of_cell& neighbors, Time step) const {
    if(field_.is_reached(c.cell))
      return before;
    const Earliest earliest = neighbors.earliest(key_of_step(step));
    if(earliest.key == key_of_step(step))
      return before;
    arrive(c, step * ticks_per_step, earliest, step);
    return 1.f;
  }

  CGAL_HTL_HOST_DEVICE void
  arrive(const Located_cell& c, Time time, const Earliest& earliest, Time step) const {
    if(earliest.is_right != 0)
      fetch_or(arrays().state[c.cell], cell_is_right);
    racy_store(arrays().time[c.cell], time);
    if(racy_load(passes().progress[step % 2][c.pass]) != step)
      fetch_max(passes().progress[step % 2][c.pass], step);
    next_place(counters().arrivals[step % 3].value);
    if(earliest.has_left && earliest.has_right)
      racy_store(counters().meetings[step % 3].value, Index(1));
    if(!arrays().reached.empty())
      arrays().reached[next_place(counters().reached.value)] = c.cell;
  }

  // Above the keys of what was reached in earlier steps.
  CGAL_HTL_HOST_DEVICE static std::uint64_t key_of_step(Time step) {
    return arrival_key((step - 1) * ticks_per_step, no_index);
  }

  Field<Domain> field_;
  Step_coefficients coefficients_;
  float spark_; // a vertex stays at zero as long as all its neighbours are below this value
  End end_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_FIELD_STEPS_H
