// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Located_cell.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/device/atomics.h>
#include <CGAL/Handle_tunnel_loops/internal/phase_field.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// The states of a cell: in the band now or before; reached from the right; marked; and, of an
/// active one, whether there may be walls beside it. Above them, once a walk has come by, the way
/// back: one more than the position of the next vertex in the ring.
constexpr std::uint32_t cell_is_active = 1, cell_is_right = 2, cell_is_marked = 4,
                        cell_may_have_walls = 8, first_bit_of_way_back = 8;

/// Counters of the steps. What one step writes is read after its barrier and cleared two steps
/// later, so there are three of each.
struct Step_counters
{
  Index band_size[3];          ///< of the list that is worked on in a step
  Index number_of_arrivals[3]; ///< in a step
  Index reached_size;          ///< of `Field_arrays::reached`
};

/// How far the steps have come.
struct Field_state
{
  Time step;
  Index band_size;
  Index number_of_reached;
  std::uint64_t number_of_updates;
};

/// All that the host looks at between runs.
struct Field_control
{
  Step_counters counters;
  Field_state state;
  Index number_of_meetings;
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
struct Field_arrays
{
  Span<float> value[2]; ///< after even and after odd steps
  Span<Time> time;
  Span<std::uint32_t> state;
  Span<Index> band[2]; ///< worked on in even and in odd steps
  Span<Index> reached; ///< cells in the order in which they were reached; or empty
  Pass_arrays passes;
  Field_control* control;
};

/// What all steps do to a cell and its neighbours. A region says what the cells are.
template <typename Region> class Field
{
public:
  Field(const Region& region, const Field_arrays& arrays)
      : region_(region)
      , arrays_(arrays) {}

  CGAL_HTL_HOST_DEVICE const Region& region() const { return region_; }
  CGAL_HTL_HOST_DEVICE const Field_arrays& arrays() const { return arrays_; }

  CGAL_HTL_HOST_DEVICE Time time(Index cell) const { return racy_load(arrays_.time[cell]); }
  CGAL_HTL_HOST_DEVICE bool is_reached(Index cell) const { return time(cell) != never; }
  CGAL_HTL_HOST_DEVICE std::uint32_t side(Index cell) const {
    return racy_load(arrays_.state[cell]) & cell_is_right;
  }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index cell) const {
    return region_.has_walls() && (racy_load(arrays_.state[cell]) & cell_may_have_walls) != 0;
  }

  /// calls `f(u, cell of u)` for each neighbour that no wall parts from the cell, which is active;
  /// the second argument is `no_index` where the field has not been.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void for_each_neighbor(const Located_cell& c, const Function& f) const {
    const Ring ring = region_.mesh().ring(c.vertex);
    const bool has_walls = may_have_walls(c.cell);
    CGAL_HTL_NO_UNROLL
    for(Index i = 0; i < ring.size(); ++i)
      if(!has_walls || !region_.is_wall(c, ring[i]))
        f(ring[i], region_.find(c, ring[i]));
  }

  /// puts the neighbours of a cell into the band of the given step, and into the field if they are
  /// new there.
  CGAL_HTL_HOST_DEVICE void activate_neighbors(const Located_cell& c, Time step) const {
    const Ring ring = region_.mesh().ring(c.vertex);
    const bool has_walls = may_have_walls(c.cell);
    CGAL_HTL_NO_UNROLL
    for(Index i = 0; i < ring.size(); ++i) {
      if(has_walls && region_.is_wall(c, ring[i]))
        continue;
      const Index u = region_.insert(c, ring[i]);
      if(u != no_index && activate({u, ring[i], c.pass}, 0)) {
        append_to_band(u, step);
        change_band_size(c.pass, step - 1, 1);
      }
    }
  }

  /// puts those of the given cells of a pass that are new into the field and into the band of the
  /// given step; some may be `no_index`.
  CGAL_HTL_HOST_DEVICE void activate(const Index (&cells)[stencil_width],
                                     const Index (&vertices)[stencil_width],
                                     Index pass,
                                     Time step) const {
    std::uint32_t states[stencil_width]; // before
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      states[i] = cells[i] == no_index ? cell_is_active : racy_load(arrays_.state[cells[i]]);
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      if((states[i] & cell_is_active) == 0)
        states[i] = make_active({cells[i], vertices[i], pass}, 0);
    Index number = 0;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      number += (states[i] & cell_is_active) == 0 ? 1 : 0;
    if(number == 0)
      return;
    Index place = fetch_add(arrays_.control->counters.band_size[step % 3], number);
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      if((states[i] & cell_is_active) == 0)
        arrays_.band[step % 2][place++] = cells[i];
    change_band_size(pass, step - 1, static_cast<int>(number));
  }

  /// notes that the band of a pass has become larger or smaller in a step.
  CGAL_HTL_HOST_DEVICE void change_band_size(Index pass, Time step, int change) const {
    const Span<Index>& changes = arrays_.passes.band_change[step % 3];
    if(!changes.empty())
      fetch_add(changes[pass], static_cast<Index>(change));
  }

  CGAL_HTL_HOST_DEVICE void append_to_band(Index cell, Time step) const {
    arrays_.band[step % 2][next_place(arrays_.control->counters.band_size[step % 3])] = cell;
  }

  /// makes a cell a source: its value is one for ever. Returns false if it is one already; only
  /// sources of one side may be added at a time.
  CGAL_HTL_HOST_DEVICE bool add_source(const Located_cell& c, Time time, std::uint32_t side) const {
    if(!activate(c, side))
      return false;
    arrays_.value[0][c.cell] = arrays_.value[1][c.cell] = 1.f;
    racy_store(arrays_.time[c.cell], time);
    return true;
  }

private:
  // Returns the state before: another thread may have been faster.
  CGAL_HTL_HOST_DEVICE std::uint32_t make_active(const Located_cell& c, std::uint32_t side) const {
    const std::uint32_t walls = region_.may_have_walls(c) ? cell_may_have_walls : 0u;
    return fetch_or(arrays_.state[c.cell], cell_is_active | side | walls);
  }

  // Returns false if the cell is active already.
  CGAL_HTL_HOST_DEVICE bool activate(const Located_cell& c, std::uint32_t side) const {
    return (racy_load(arrays_.state[c.cell]) & cell_is_active) == 0 &&
           (make_active(c, side) & cell_is_active) == 0;
  }

  Region region_;
  Field_arrays arrays_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FIELD_H
