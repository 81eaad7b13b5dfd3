// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CLOSE_WALKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CLOSE_WALKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Meetings.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Walls.h>
#include <CGAL/Handle_tunnel_loops/internal/steepest_descent.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// A closed walk that a pass has found: `size` vertices from `begin`.
struct Found_walk
{
  Index pass;
  Index rank; ///< among those of the pass
  Index begin, size;
};

/// Where walks are written.
struct Walk_list
{
  Span<Found_walk> walks;
  Index* number_of_walks;
  Span<Index> vertices;
  Index* number_of_vertices;
  Index* number_of_lost_walks; ///< that did not come back to their loop
};

/*!
Closes walks at the meetings of a pass, for one thread per pass, as `Loop_pass` does: the best
meeting of each step first, none that continues an earlier one, none whose walk crosses the loop
other than once or another wall. From a meeting the way goes back to either side, down the steepest
edges, and along the left side of the loop, the short way, to where it began.
*/
template <typename Region> class Close_walks
{
public:
  /// What each pass is about.
  struct Passes
  {
    Span<const Index> begin; ///< by pass, its first meeting
    Span<Index> number_of_walks;
    Index wanted_walks;
  };

  Close_walks(const Field<Region>& field,
              const Loop_sides& sides,
              const Span<const Meeting>& meetings,
              const Passes& passes,
              const Walk_list& out)
      : field_(field)
      , sides_(sides)
      , meetings_(meetings)
      , passes_(passes)
      , out_(out) {}

  CGAL_HTL_HOST_DEVICE void operator()(Index pass) const {
    if(region().is_starved(pass))
      return;
    Index& number_of_walks = passes_.number_of_walks[pass];
    Time& last_step = field_.arrays().passes.last_step[pass];
    for(Index i = passes_.begin[pass]; i < passes_.begin[pass + 1]; ++i) {
      const Meeting& meeting = meetings_[i];
      if(number_of_walks == passes_.wanted_walks || meeting.step > last_step)
        break;
      if(continues_a_meeting(meeting) || !close(meeting, number_of_walks))
        continue;
      mark(meeting);
      const Time a_third_later = meeting.step * 4 / 3 + 1;
      if(number_of_walks == 0 && a_third_later < last_step)
        last_step = a_third_later;
      ++number_of_walks;
    }
    if(number_of_walks == passes_.wanted_walks)
      last_step = 0;
  }

private:
  CGAL_HTL_HOST_DEVICE const Region& region() const { return field_.region(); }

  CGAL_HTL_HOST_DEVICE bool is_marked(Index pass, Index v) const {
    const Index cell = region().find_in_pass(pass, v);
    return cell != no_index && (field_.arrays().state[cell] & cell_is_marked) != 0;
  }

  CGAL_HTL_HOST_DEVICE void mark(const Meeting& meeting) const {
    field_.arrays().state[region().find_in_pass(meeting.pass, meeting.left)] |= cell_is_marked;
    field_.arrays().state[region().find_in_pass(meeting.pass, meeting.right)] |= cell_is_marked;
  }

  CGAL_HTL_HOST_DEVICE bool is_marked_near(Index pass, Index v) const {
    bool result = is_marked(pass, v);
    const Ring ring = region().mesh().ring(v);
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

  // The next cell on the way back. Each walk is gone twice, and walks come together: the way is
  // noted.
  CGAL_HTL_NO_INLINE CGAL_HTL_HOST_DEVICE Located_cell back(const Located_cell& c) const {
    std::uint32_t& state = field_.arrays().state[c.cell];
    const Ring ring = region().mesh().ring(c.vertex);
    if(state >> first_bit_of_way_back == 0)
      state |= (ring.position(vertex_down(c)) + 1) << first_bit_of_way_back;
    const Index position = (state >> first_bit_of_way_back) - 1;
    if(position == ring.size())
      return {no_index, no_index, c.pass};
    return {region().find(c, ring[position]), ring[position], c.pass};
  }

  CGAL_HTL_HOST_DEVICE Index vertex_down(const Located_cell& c) const {
    const std::uint32_t side = field_.side(c.cell);
    return steepest_descent(
        region().mesh(), c.vertex,
        [&](Index u) {
          const Index neighbor = region().find(c, u);
          return neighbor == no_index ? never : field_.time(neighbor);
        },
        [&](Index u) {
          return field_.side(region().find(c, u)) == side && !region().is_wall(c, u);
        });
  }

  // The way back from a vertex: calls `f` for each vertex of it, and returns its last vertex. It
  // goes down, so it ends: at time zero, or, which would be an error, where there is no way down.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE Index go_back(Index pass, Index v, const Function& f) const {
    Located_cell c = {region().find_in_pass(pass, v), v, pass};
    f(v);
    while(c.cell != no_index && field_.time(c.cell) != 0) {
      c = back(c);
      f(c.vertex);
    }
    return c.vertex;
  }

  // Whether there is a walk, which is then written.
  CGAL_HTL_HOST_DEVICE bool close(const Meeting& meeting, Index rank) const {
    Index to_left = 0, to_right = 0, along = 0;
    const Index left = go_back(meeting.pass, meeting.left, [&](Index) { ++to_left; });
    const Index right = go_back(meeting.pass, meeting.right, [&](Index) { ++to_right; });
    Way_along_loop way = sides_.way_along(meeting.pass);
    if(!way.find(&Crossing::left, left, &Crossing::right, right)) {
      fetch_add(*out_.number_of_lost_walks, 1);
      return false;
    }
    if(!is_dual(region().loop(meeting.pass), way, right))
      return false;
    way.for_each([&](const Crossing&) { ++along; });
    const Index size = to_right + to_left + along;
    const Index begin = fetch_add(*out_.number_of_vertices, size);
    const Index place = next_place(*out_.number_of_walks);
    if(std::size_t(begin) + size > out_.vertices.size() || place >= out_.walks.size()) {
      region().starve(meeting.pass);
      return true;
    }
    out_.walks[place] = {meeting.pass, rank, begin, size};
    write(meeting, way, begin + to_right);
    return true;
  }

  CGAL_HTL_HOST_DEVICE void
  write(const Meeting& meeting, const Way_along_loop& way, Index middle) const {
    Index* before = out_.vertices.data() + middle;
    Index* after = before;
    go_back(meeting.pass, meeting.right, [&](Index v) { *--before = v; });
    go_back(meeting.pass, meeting.left, [&](Index v) { *after++ = v; });
    way.for_each([&](const Crossing& c) { *after++ = c.left; });
  }

  // Whether the loop is crossed once, and no other wall. The ways back cross none, so all crossings
  // are along the loop and at its end.
  CGAL_HTL_HOST_DEVICE bool is_dual(Index loop, const Way_along_loop& way, Index right) const {
    const int once = crossings(loop, way, right);
    if(once != 1 && once != -1)
      return false;
    bool result = true;
    for_each_edge(way, right, [&](Index u, Index v) {
      region().walls().for_each_other_wall(
          loop, u, v, [&](Index other) { result = result && crossings(other, way, right) == 0; });
    });
    return result;
  }

  // Calls `f` for each edge along the loop and across its end.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void
  for_each_edge(const Way_along_loop& way, Index right, const Function& f) const {
    Index last = no_index;
    way.for_each([&](const Crossing& c) {
      if(last != no_index && last != c.left)
        f(last, c.left);
      last = c.left;
    });
    f(last, right);
  }

  CGAL_HTL_HOST_DEVICE int crossings(Index loop, const Way_along_loop& way, Index right) const {
    int sum = 0;
    for_each_edge(way, right,
                  [&](Index u, Index v) { sum += region().walls().crossings(loop, u, v); });
    return sum;
  }

  Field<Region> field_;
  Loop_sides sides_;
  Span<const Meeting> meetings_;
  Passes passes_;
  Walk_list out_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CLOSE_WALKS_H
