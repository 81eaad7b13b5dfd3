// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/executors/atomics.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/kernels/Located_cell.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

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
template <typename Domain> class Field
{
public:
  using Banded_cell = typename Domain::Banded_cell;
  using Arrays = Field_arrays<Banded_cell>;

  Field(const Domain& domain, const Arrays& arrays)
      : domain_(domain)
      , arrays_(arrays) {}

  CGAL_HTL_HOST_DEVICE const Domain& domain() const { return domain_; }
  CGAL_HTL_HOST_DEVICE const Arrays& arrays() const { return arrays_; }

  CGAL_HTL_HOST_DEVICE Time time(Index cell) const { return racy_load(arrays_.time[cell]); }
  CGAL_HTL_HOST_DEVICE bool is_reached(Index cell) const { return time(cell) != never; }
  CGAL_HTL_HOST_DEVICE std::uint32_t side(Index cell) const {
    return racy_load(arrays_.state[cell]) & cell_is_right;
  }
  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index cell) const {
    return domain_.has_walls() && (racy_load(arrays_.state[cell]) & cell_may_have_walls) != 0;
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
      states[i] = cells[i] == no_index ? cell_is_active : racy_load(arrays_.state[cells[i]]);
      walls[i] = cells[i] != no_index && domain_.may_have_walls(vertices[i], false)
                     ? cell_may_have_walls
                     : 0u;
    }
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      if((states[i] & cell_is_active) == 0) // another thread may be faster
        states[i] = fetch_or(arrays_.state[cells[i]], cell_is_active | walls[i]);
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
    const Span<Index>& changes = arrays_.passes.band_change[step % 3];
    if(!changes.empty())
      fetch_add(changes[pass], static_cast<Index>(change));
  }

  /// makes a cell a source: its value is one for ever. Returns false if it is one already; only
  /// sources of one side may be added at a time.
  CGAL_HTL_HOST_DEVICE bool add_source(const Located_cell& c, Time time, std::uint32_t side) const {
    const std::uint32_t walls = domain_.may_have_walls(c.vertex, true) ? cell_may_have_walls : 0u;
    if((racy_load(arrays_.state[c.cell]) & cell_is_active) != 0 ||
       (fetch_or(arrays_.state[c.cell], cell_is_active | side | walls) & cell_is_active) != 0)
      return false;
    arrays_.value[0][c.cell] = arrays_.value[1][c.cell] = 1.f;
    racy_store(arrays_.time[c.cell], time);
    return true;
  }

private:
  CGAL_HTL_HOST_DEVICE Step_counters& counters() const { return arrays_.control->counters; }
  CGAL_HTL_HOST_DEVICE const Span<Banded_cell>& next_list(const Field_state& now) const {
    return arrays_.band[list_of_step(now.step + 1)];
  }

  Domain domain_;
  Arrays arrays_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_FIELD_H
