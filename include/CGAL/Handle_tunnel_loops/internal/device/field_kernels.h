// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_KERNELS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_KERNELS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// A cell of a field, the vertex that it stands for, and the pass that it belongs to: looked up
/// once, and then passed on.
struct Located_cell
{
  Index cell, vertex, pass;
};

/// The states of a cell: in the band now or before; reached from the right; marked; and, of an
/// active one, whether there may be walls beside it.
constexpr std::uint32_t cell_is_active = 1, cell_is_right = 2, cell_is_marked = 4,
                        cell_may_have_walls = 8;

/// So many steps a cell keeps its place in the list of the band. Then a new list is made, without
/// those that have left the band.
constexpr Time steps_per_list = 16;

CGAL_HTL_HOST_DEVICE inline bool is_end_of_list(Time step) { return step % steps_per_list == 0; }

/// which of the two lists a step works on, from step 1 on.
CGAL_HTL_HOST_DEVICE inline Index list_of_step(Time step) {
  return (step + steps_per_list - 1) / steps_per_list % 2;
}

/// What a step counts. It is read after its barrier and cleared two steps later, so there are three
/// of each; each in a cache line of its own.
struct Step_counters
{
  struct alignas(128) Counter
  {
    Index value;
    Index unused[31];
  };
  Counter added[3]; ///< to the list of the next step
  Counter left[3];  ///< the band
  Counter arrivals[3];
  Counter meetings[3]; ///< of fronts from different sides; some are not counted
  Counter reached;     ///< in `Field_arrays::reached`
};

/// How far the steps have come; all threads know it.
struct Field_state
{
  Time step;
  Index list_size;      ///< in this step
  Index number_of_dead; ///< that have left the band, but not the list
  Index next_list_size; ///< after this step
  Index number_of_reached;
  std::uint32_t has_met; ///< whether a meeting was counted in this run
  std::uint64_t number_of_updates;

  /// where what is added to the list of the next step has its places.
  CGAL_HTL_HOST_DEVICE Index first_free_place() const {
    return is_end_of_list(step) ? 0 : list_size;
  }
};

static_assert(sizeof(Field_state) == 32, "see `Field_control::unused`");

/// All that the host looks at between runs.
struct Field_control
{
  Field_state state;
  Index number_of_meetings;
  Index unused[23];
  Step_counters counters;
};

/// What is known of each pass.
struct Pass_arrays
{
  Span<Time> progress[2];       ///< when it last came on, by the end of even and of odd steps
  Span<Time> last_step;         ///< that it makes
  Span<Index> band_change[3];   ///< by how much its band grows; see `Step_counters`. Or empty:
  Span<Index> band_size;        ///< then nobody asks how many
  Span<std::uint64_t> updates;  ///< it has made
  std::uint64_t enough_updates; ///< after which it ends
};

/*!
The field of `Narrow_band` for many threads: all its values and times, and the list of the cells
that may change. A step reads the values of the last one and writes beside them, so that one barrier
is enough. What leaves the band, having come to one, is written once more to have both values agree.
*/
template <typename Banded_cell> struct Field_arrays
{
  Span<float> value[2]; ///< after even and after odd steps
  Span<Time> time;
  Span<std::uint32_t> state;
  Span<Banded_cell> band[2];
  Span<Index> reached; ///< cells in the order in which they were reached; or empty
  Span<Index> back;    ///< the next cell on the way back, `no_index` at sources; or empty
  Pass_arrays passes;
  Field_control* control;
};

/// What all steps do to a cell and its neighbours. A domain says what the cells are.
template <typename Domain> struct Field
{
  using Banded_cell = typename Domain::Banded_cell;
  using Arrays = Field_arrays<Banded_cell>;

  Domain domain;
  Arrays arrays;

  CGAL_HTL_HOST_DEVICE Time time(Index cell) const { return racy_load(arrays.time[cell]); }
  CGAL_HTL_HOST_DEVICE bool is_reached(Index cell) const { return time(cell) != never; }
  CGAL_HTL_HOST_DEVICE std::uint32_t side(Index cell) const {
    return racy_load(arrays.state[cell]) & cell_is_right;
  }
  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index cell) const {
    return domain.has_walls() && (racy_load(arrays.state[cell]) & cell_may_have_walls) != 0;
  }

  /// puts those of the given cells of a pass that are new into the field, and into the band from
  /// the next step on; some may be `no_index`.
  CGAL_HTL_HOST_DEVICE void activate(const Index (&cells)[stencil_width],
                                     const Index (&vertices)[stencil_width],
                                     Index pass,
                                     const Field_state& now) const {
    std::uint32_t states[stencil_width]; // before
    std::uint32_t walls[stencil_width];
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i) {
      states[i] = cells[i] == no_index ? cell_is_active : racy_load(arrays.state[cells[i]]);
      walls[i] = cells[i] != no_index && domain.may_have_walls(vertices[i], false)
                     ? cell_may_have_walls
                     : 0u;
    }
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      if((states[i] & cell_is_active) == 0) // another thread may be faster
        states[i] = fetch_or(arrays.state[cells[i]], cell_is_active | walls[i]);
    Index number = 0;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      number += (states[i] & cell_is_active) == 0 ? 1 : 0;
    if(number == 0)
      return;
    Index place = now.first_free_place() + fetch_add(counters().added[now.step % 3].value, number);
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      if((states[i] & cell_is_active) == 0)
        next_list(now)[place++] = Domain::banded({cells[i], vertices[i], pass});
    change_band_size(pass, now.step, static_cast<int>(number));
  }

  /// takes a cell over into a new list.
  CGAL_HTL_HOST_DEVICE void keep(const Located_cell& c, const Field_state& now) const {
    next_list(now)[next_place(counters().added[now.step % 3].value)] = Domain::banded(c);
  }

  /// notes that the band of a pass has become larger or smaller in a step.
  CGAL_HTL_HOST_DEVICE void change_band_size(Index pass, Time step, int change) const {
    const Span<Index>& changes = arrays.passes.band_change[step % 3];
    if(!changes.empty())
      fetch_add(changes[pass], static_cast<Index>(change));
  }

  /// makes a cell a source: its value is one for ever. Returns false if it is one already; only
  /// sources of one side may be added at a time.
  CGAL_HTL_HOST_DEVICE bool add_source(const Located_cell& c, Time time, std::uint32_t side) const {
    const std::uint32_t walls = domain.may_have_walls(c.vertex, true) ? cell_may_have_walls : 0u;
    if((racy_load(arrays.state[c.cell]) & cell_is_active) != 0 ||
       (fetch_or(arrays.state[c.cell], cell_is_active | side | walls) & cell_is_active) != 0)
      return false;
    arrays.value[0][c.cell] = arrays.value[1][c.cell] = 1.f;
    racy_store(arrays.time[c.cell], time);
    return true;
  }

private:
  CGAL_HTL_HOST_DEVICE Step_counters& counters() const { return arrays.control->counters; }
  CGAL_HTL_HOST_DEVICE const Span<Banded_cell>& next_list(const Field_state& now) const {
    return arrays.band[list_of_step(now.step + 1)];
  }
};

/// the next cell on the way back from a cell that is reached to the source that its front set out
/// from: down the steepest edge, on the same side and through no wall. It was reached earlier, so
/// ways end. `no_index` if there is none, which would be an error.
template <typename Domain>
CGAL_HTL_HOST_DEVICE Index path_back(const Field<Domain>& field, const Located_cell& c) {
  const std::uint32_t side = field.side(c.cell);
  const Index next = steepest_descent(
      field.domain.mesh(), c.vertex,
      [&](Index u) {
        const Index neighbor = field.domain.find(c, u);
        return neighbor == no_index ? never : field.time(neighbor);
      },
      [&](Index u) {
        return field.side(field.domain.find(c, u)) == side && !field.domain.is_wall(c, u);
      });
  return next == c.vertex ? no_index : field.domain.find(c, next);
}

/*!
The neighbours of a cell that no wall parts from it: what a step wants of them. They are loaded
eight at a time, so that a thread waits for the memory once and not for each of them, and the first
eight are kept.
*/
template <typename Domain> class Neighbors
{
  /// Some of the neighbours, and their cells; `no_index` beyond the last and behind walls, and for
  /// the cells of vertices where the field has not been.
  struct Some
  {
    Index vertices[stencil_width], cells[stencil_width];
  };

public:
  CGAL_HTL_HOST_DEVICE Neighbors(const Field<Domain>& field, const Located_cell& cell)
      : Neighbors(field,
                  cell,
                  field.domain.mesh().rows[cell.vertex],
                  field.domain.mesh().ring(cell.vertex),
                  field.may_have_walls(cell.cell)) {}

  /// the same where all that is asked for has been loaded before.
  CGAL_HTL_HOST_DEVICE Neighbors(const Field<Domain>& field,
                                 const Located_cell& cell,
                                 const Neighbor_row& row,
                                 const Ring& ring,
                                 bool has_walls)
      : field_(field)
      , cell_(cell)
      , ring_(ring)
      , has_walls_(has_walls) {
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      first_.vertices[i] = row.at[i];
    find_cells(first_);
  }

  /// calls `f` for each neighbour and its cell.
  template <typename Function> CGAL_HTL_HOST_DEVICE void for_each(const Function& f) const {
    for_each_eight([&](const Some& some) {
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        if(some.vertices[i] != no_index)
          f(some.vertices[i], some.cells[i]);
    });
  }

  /// in the order of summation that the host has, too.
  CGAL_HTL_HOST_DEVICE float mean(const Span<float>& value) const {
    const auto value_of = [&](Index cell) { return cell == no_index ? 0.f : value[cell]; };
    if(!has_walls_ && ring_.size() <= stencil_width)
      return stencil_mean(1.f / static_cast<float>(ring_.size()),
                          [&](Index i) { return value_of(first_.cells[i]); });
    float sum = 0.f;
    std::uint64_t whole_sum = 0;
    Index number = 0;
    const bool is_long = ring_.size() > many_neighbors;
    for_each_eight([&](const Some& some) {
      float values[stencil_width];
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        values[i] = value_of(some.cells[i]);
      if(is_long) {
        CGAL_HTL_UNROLL
        for(Index i = 0; i < stencil_width; ++i)
          whole_sum += whole_value(values[i]);
      }
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i) {
        sum += values[i];
        number += some.vertices[i] != no_index ? 1 : 0;
      }
    });
    return is_long ? mean_of_whole_values(whole_sum, number) : sum / static_cast<float>(number);
  }

  /// Where a front comes from.
  struct Earliest
  {
    std::uint64_t key;        ///< the least arrival key
    std::uint32_t is_right;   ///< of that neighbour: `cell_is_right` or zero
    bool has_left, has_right; ///< whether there are neighbours reached from the left, the right
  };

  /// the neighbour with the least arrival key of those below a given one, which `key` is else.
  CGAL_HTL_HOST_DEVICE Earliest earliest(std::uint64_t key) const {
    Earliest found = {key, 0, false, false};
    for_each_eight([&](const Some& some) {
      Time times[stencil_width];
      std::uint32_t sides[stencil_width];
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i) {
        times[i] = some.cells[i] == no_index ? never : field_.time(some.cells[i]);
        sides[i] = Domain::has_sides && some.cells[i] != no_index ? field_.side(some.cells[i]) : 0;
      }
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i) {
        const std::uint64_t other = arrival_key(times[i], some.vertices[i]);
        found.has_left = found.has_left || (other < key && sides[i] == 0);
        found.has_right = found.has_right || (other < key && sides[i] != 0);
        found.is_right = other < found.key ? sides[i] : found.is_right;
        found.key = other < found.key ? other : found.key;
      }
    });
    return found;
  }

  /// has all of them in the band from the next step on.
  CGAL_HTL_HOST_DEVICE void activate(const Field_state& now) const {
    for_each_eight([&](Some some) {
      field_.domain.insert(some.cells, some.vertices, cell_.pass);
      field_.activate(some.cells, some.vertices, cell_.pass, now);
    });
  }

private:
  CGAL_HTL_HOST_DEVICE void find_cells(Some& some) const {
    if(has_walls_) {
      const std::uint32_t walls = field_.domain.walls_among(some.vertices, cell_);
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        some.vertices[i] = (walls >> i & 1) != 0 ? no_index : some.vertices[i];
    }
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      some.cells[i] =
          some.vertices[i] == no_index ? no_index : field_.domain.find(cell_, some.vertices[i]);
  }

  template <typename Function> CGAL_HTL_HOST_DEVICE void for_each_eight(const Function& f) const {
    f(first_);
    CGAL_HTL_NO_UNROLL
    for(Index begin = stencil_width; begin < ring_.size(); begin += stencil_width) {
      Some some;
      CGAL_HTL_UNROLL
      for(Index i = 0; i < stencil_width; ++i)
        some.vertices[i] = begin + i < ring_.size() ? ring_[begin + i] : no_index;
      find_cells(some);
      f(some);
    }
  }

  const Field<Domain>& field_;
  Located_cell cell_;
  Ring ring_;
  bool has_walls_;
  Some first_;
};

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
    return field_.arrays;
  }
  CGAL_HTL_HOST_DEVICE const Pass_arrays& passes() const { return field_.arrays.passes; }
  CGAL_HTL_HOST_DEVICE Step_counters& counters() const { return arrays().control->counters; }
  CGAL_HTL_HOST_DEVICE const Domain& domain() const { return field_.domain; }
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

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_KERNELS_H
