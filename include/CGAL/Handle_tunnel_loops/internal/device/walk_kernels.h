// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WALK_KERNELS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WALK_KERNELS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/domains.h>
#include <CGAL/Handle_tunnel_loops/internal/device/field_kernels.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <tuple>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// The loops of the passes, pass after pass.
struct Loop_sides
{
  Span<const Crossing> crossings;
  Span<const Index> pass;   ///< by crossing
  Span<const Index> begin;  ///< by pass, its first crossing
  Span<const double> along; ///< by pass, one more than crossings: see `Shorter_arc`

  CGAL_HTL_HOST_DEVICE Shorter_arc way_along(Index k) const {
    const Index first = begin[k];
    return {crossings.data() + first, begin[k + 1] - first, along.data() + first + k};
  }
};

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
    const Located_cell c = field.domain.located(field.arrays.reached[i]);
    note_meetings(field, c, list);
    field.arrays.back[c.cell] = path_back(field, c);
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
    const Index left = field.domain.find_in_pass(pass, c.left);
    const Index right = field.domain.find_in_pass(pass, c.right);
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
    const Index cell = field.domain.insert_in_pass(pass, v);
    if(cell != no_index)
      field.add_source({cell, v, pass}, 0, round == Round::RIGHT ? cell_is_right : 0u);
  }
};

/// A closed walk that a pass has found: `size` vertices from `begin`.
struct Found_walk
{
  Index pass;
  Index rank; ///< among those of the pass
  std::uint64_t begin, size;
};

/// How much was found. More than there is room for is counted, too.
struct Walk_counters
{
  std::uint64_t vertices;
  Index walks;
  Index lost; ///< that did not come back to their loop
};

/// Where the walks that are found go.
struct Walk_list
{
  Span<Found_walk> walks;
  Span<Index> vertices;
  Walk_counters* counters;
};

/*!
Closes walks at the meetings of a pass, for one thread per pass, as `Bidirectional_front` does: the
best meeting of each step first, none that continues an earlier one, none whose walk crosses the
loop other than once or another wall. From a meeting the way goes back to either side, as noted, and
along the left side of the loop, the short way, to where it began.
*/
template <typename Domain> struct Close_walks
{
  Field<Domain> field;
  Loop_sides sides;
  Span<const Meeting> meetings;
  Span<const Index> first_meetings; ///< by pass, and the end
  Span<Index> numbers_of_walks;     ///< by pass
  Index wanted_walks;
  Walk_list out;

  CGAL_HTL_HOST_DEVICE void operator()(Index pass) const {
    if(domain().is_starved(pass))
      return;
    Index& number_of_walks = numbers_of_walks[pass];
    Time& last_step = field.arrays.passes.last_step[pass];
    for(Index i = first_meetings[pass]; i < first_meetings[pass + 1]; ++i) {
      const Meeting& meeting = meetings[i];
      if(number_of_walks == wanted_walks || meeting.step > last_step)
        break;
      if(continues_a_meeting(meeting) || !close(meeting, number_of_walks))
        continue;
      mark(meeting);
      const Time a_third_later = meeting.step * 4 / 3 + 1;
      if(number_of_walks == 0 && a_third_later < last_step)
        last_step = a_third_later;
      ++number_of_walks;
    }
    if(number_of_walks == wanted_walks)
      last_step = 0;
  }

private:
  CGAL_HTL_HOST_DEVICE const Domain& domain() const { return field.domain; }

  CGAL_HTL_HOST_DEVICE bool is_marked(Index pass, Index v) const {
    const Index cell = domain().find_in_pass(pass, v);
    return cell != no_index && (field.arrays.state[cell] & cell_is_marked) != 0;
  }

  CGAL_HTL_HOST_DEVICE void mark(const Meeting& meeting) const {
    field.arrays.state[domain().find_in_pass(meeting.pass, meeting.left)] |= cell_is_marked;
    field.arrays.state[domain().find_in_pass(meeting.pass, meeting.right)] |= cell_is_marked;
  }

  CGAL_HTL_HOST_DEVICE bool is_marked_near(Index pass, Index v) const {
    bool result = is_marked(pass, v);
    const Ring ring = domain().mesh().ring(v);
    for(Index i = 0; i < ring.size() && !result; ++i)
      result = is_marked(pass, ring[i]);
    return result;
  }

  // Once the fronts have met in one place, they go on meeting beside it.
  CGAL_HTL_HOST_DEVICE bool continues_a_meeting(const Meeting& meeting) const {
    if(!is_marked_near(meeting.pass, meeting.left) && !is_marked_near(meeting.pass, meeting.right))
      return false;
    mark(meeting);
    return true;
  }

  // The way back from a vertex: calls `f` for each cell of it, and returns its last vertex.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE Index go_back(Index pass, Index v, const Function& f) const {
    Index cell = domain().find_in_pass(pass, v);
    f(cell);
    CGAL_HTL_NO_UNROLL
    for(Index next = back(cell); next != no_index; next = back(cell)) {
      cell = next;
      f(cell);
    }
    return vertex(cell);
  }

  CGAL_HTL_HOST_DEVICE Index back(Index cell) const { return field.arrays.back[cell]; }
  CGAL_HTL_HOST_DEVICE Index vertex(Index cell) const { return domain().located(cell).vertex; }

  // Whether there is a walk, which is then written.
  CGAL_HTL_HOST_DEVICE bool close(const Meeting& meeting, Index rank) const {
    Index to_left = 0, to_right = 0, along = 0;
    const Index left = go_back(meeting.pass, meeting.left, [&](Index) { ++to_left; });
    const Index right = go_back(meeting.pass, meeting.right, [&](Index) { ++to_right; });
    Shorter_arc way = sides.way_along(meeting.pass);
    if(!way.find(&Crossing::left, left, &Crossing::right, right)) {
      fetch_add(out.counters->lost, Index(1));
      return false;
    }
    if(!is_dual(domain().loop(meeting.pass), way, right))
      return false;
    way.for_each([&](const Crossing&) { ++along; });
    const Index size = to_right + to_left + along;
    const std::uint64_t begin = fetch_add(out.counters->vertices, std::uint64_t(size));
    const Index place = next_place(out.counters->walks);
    if(begin + size > out.vertices.size() || place >= out.walks.size()) {
      domain().starve(meeting.pass);
      return true;
    }
    out.walks[place] = {meeting.pass, rank, begin, size};
    write(meeting, way, begin + to_right);
    return true;
  }

  CGAL_HTL_HOST_DEVICE void
  write(const Meeting& meeting, const Shorter_arc& way, std::uint64_t middle) const {
    Index* before = out.vertices.data() + middle;
    Index* after = before;
    go_back(meeting.pass, meeting.right, [&](Index cell) { *--before = vertex(cell); });
    go_back(meeting.pass, meeting.left, [&](Index cell) { *after++ = vertex(cell); });
    way.for_each([&](const Crossing& c) { *after++ = c.left; });
  }

  // Whether the loop is crossed once, and no other wall. The ways back cross none, so all crossings
  // are along the loop and at its end.
  CGAL_HTL_HOST_DEVICE bool is_dual(Index loop, const Shorter_arc& way, Index right) const {
    const int once = crossings(loop, way, right);
    if(once != 1 && once != -1)
      return false;
    bool result = true;
    Index tested = no_index; // loops run side by side: mostly it is the same one again
    for_each_edge(way, right, [&](Index u, Index v) {
      domain().walls().for_each_other_wall(loop, u, v, [&](Index other) {
        if(result && other != tested)
          result = crossings(other, way, right) == 0;
        tested = other;
      });
    });
    return result;
  }

  // Calls `f` for each edge along the loop and across its end.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void
  for_each_edge(const Shorter_arc& way, Index right, const Function& f) const {
    Index last = no_index;
    way.for_each([&](const Crossing& c) {
      if(last != no_index && last != c.left)
        f(last, c.left);
      last = c.left;
    });
    f(last, right);
  }

  CGAL_HTL_HOST_DEVICE int crossings(Index loop, const Shorter_arc& way, Index right) const {
    int sum = 0;
    for_each_edge(way, right,
                  [&](Index u, Index v) { sum += domain().walls().crossings(loop, u, v); });
    return sum;
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WALK_KERNELS_H
