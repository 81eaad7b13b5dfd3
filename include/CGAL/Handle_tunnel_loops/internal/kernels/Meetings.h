// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_MEETINGS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_MEETINGS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/kernels/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/kernels/Neighbors.h>
#include <CGAL/Handle_tunnel_loops/internal/kernels/path_back.h>

#include <tuple>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// An edge, or one vertex, at which what was reached from the left meets what was reached from the
/// right.
struct Meeting
{
  Index pass;
  Time step;          ///< in which it came about
  std::uint64_t time; ///< on both ways together
  Index left, right;

  /// the order in which the pass looks at them.
  friend bool operator<(const Meeting& a, const Meeting& b) {
    return std::tie(a.pass, a.step, a.time, a.left, a.right) <
           std::tie(b.pass, b.step, b.time, b.left, b.right);
  }
};

/// Where meetings are noted; what finds no room is counted.
struct Meeting_list
{
  Span<Meeting> meetings;
  Index* size;

  CGAL_HTL_HOST_DEVICE void append(const Meeting& meeting) const {
    const Index place = next_place(*size);
    if(place < meetings.size())
      meetings[place] = meeting;
  }
};

template <typename Domain>
CGAL_HTL_NO_INLINE CGAL_HTL_HOST_DEVICE void
note_meetings(const Field<Domain>& field, const Located_cell& c, const Meeting_list& list) {
  const Time time = field.time(c.cell);
  const std::uint32_t side = field.side(c.cell);
  Neighbors<Domain>(field, c).for_each([&](Index u, Index neighbor) {
    if(neighbor == no_index || field.side(neighbor) == side)
      return;
    // Each edge is noted once, from the end that was reached last.
    const Time other = field.time(neighbor);
    if(other == never || arrival_key(other, u) > arrival_key(time, c.vertex))
      return;
    const Time step = (time + ticks_per_step - 1) / ticks_per_step;
    const bool is_right = side != 0;
    list.append({c.pass, step, std::uint64_t(time) + other, is_right ? u : c.vertex,
                 is_right ? c.vertex : u});
  });
}

/// What is noted of a cell that the field has reached since the last look: where it meets others,
/// and its way back.
template <typename Domain> struct Look_at_reached
{
  Field<Domain> field;
  Meeting_list list;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    const Located_cell c = field.domain().located(field.arrays().reached[i]);
    note_meetings(field, c, list);
    field.arrays().back[c.cell] = path_back(field, c);
  }
};

/// The sources of the passes, in rounds over all crossings of all loops: the left sides; the right
/// sides; what is beside them; the vertices that are on both sides; the edges between them.
template <typename Domain> struct Start_passes
{
  enum class Round { LEFT, RIGHT, BAND, RIGHT_AGAIN, MEETINGS };

  Field<Domain> field;
  Loop_sides sides;
  Meeting_list list;
  Round round;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    const Index pass = sides.pass[i];
    const Crossing& c = sides.crossings[i];
    if(round == Round::LEFT || round == Round::RIGHT)
      return add_source(pass, round == Round::LEFT ? c.left : c.right);
    const Index left = field.domain().find_in_pass(pass, c.left);
    const Index right = field.domain().find_in_pass(pass, c.right);
    if(left == no_index || right == no_index)
      return; // the pass is starved
    if(round == Round::BAND) {
      activate_neighbors({left, c.left, pass});
      activate_neighbors({right, c.right, pass});
    } else if(round == Round::RIGHT_AGAIN) {
      if(field.side(right) == 0)
        list.append({pass, 0, 0, c.right, c.right});
    } else {
      note_meetings(field, {left, c.left, pass}, list);
      note_meetings(field, {right, c.right, pass}, list);
    }
  }

private:
  CGAL_HTL_NO_INLINE CGAL_HTL_HOST_DEVICE void activate_neighbors(const Located_cell& c) const {
    Neighbors<Domain>(field, c).activate(Field_state());
  }

  CGAL_HTL_HOST_DEVICE void add_source(Index pass, Index v) const {
    const Index cell = field.domain().insert_in_pass(pass, v);
    if(cell != no_index)
      field.add_source({cell, v, pass}, 0, round == Round::RIGHT ? cell_is_right : 0u);
  }
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_MEETINGS_H
