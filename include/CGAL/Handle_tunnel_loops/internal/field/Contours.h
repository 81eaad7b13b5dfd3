// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_CONTOURS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_CONTOURS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Swept_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// \file saddle_formulas.h
/// What is computed at one vertex or one crossing of a contour, for host and device alike.

/// the number of maximal runs of vertices in a ring that are earlier than its center: 0 at a
/// minimum, at least 2 at a saddle; a maximum has one that is the whole ring, as a regular vertex
/// has one that is not. (A whole ring has no change, and counts 0 here too.)
template <typename Is_earlier>
CGAL_HTL_HOST_DEVICE Index count_lower_components(Ring ring, const Is_earlier& is_earlier) {
  bool previous = is_earlier(ring[ring.size() - 1]);
  Index changes = 0;
  for(Index i = 0; i < ring.size(); ++i) {
    const bool current = is_earlier(ring[i]);
    changes += current != previous;
    previous = current;
  }
  return changes / 2;
}

/// Contours pass edges at ratios away from the ends.
constexpr double smallest_ratio = 0.01, largest_ratio = 0.99;

/// where the contour at time `at` passes an edge.
CGAL_HTL_HOST_DEVICE inline Crossing
contour_crossing(Index left, Index right, Time time_left, Time time_right, Time at) {
  const double from = time_left, to = time_right;
  const double ratio = to > from ? (at - from) / (to - from) : 0.5;
  const double bounded = ratio < smallest_ratio ? smallest_ratio : ratio;
  return {left, right, bounded > largest_ratio ? largest_ratio : bounded};
}

/// A lower component of earlier vertices around a saddle, and the arc of the contour that leaves
/// it: what `Saddle` says of them, but for the crossings of the arc, which are not kept.
struct Lower_component_arc
{
  Index first, last; ///< positions in the ring, counterclockwise
  Index foot;        ///< the first vertex
  Index left, right; ///< ends of the edge where the arc is
  Index arc_size;
  Index arrival;      ///< the lower component at which the arc arrives
  Index handle_start; ///< if the contours before this lower component and at it meet: where the
                      ///< loop begins
  Index handle_size;
};

/// The contours at a saddle as cycles of the lower components at which they arrive, when lower
/// components 0 .. step - 1 have been joined: with step 1 just below the saddle, with as many steps
/// as there are lower components just above it.
struct Contour_cycles
{
  Span<const Lower_component_arc> lower_components;

  /// calls `f(at, leaving)` for the lower components at which the contour through `start` arrives,
  /// and those at which it leaves then.
  CGAL_HTL_CALLS_ANY_FUNCTION
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void for_each(Index start, Index step, const Function& f) const {
    Index at = start;
    do {
      const Index leaving = target(at, step);
      f(at, leaving);
      at = lower_components[leaving].arrival;
    } while(at != start);
  }

  /// whether the contours that arrive at two lower components are one.
  CGAL_HTL_HOST_DEVICE bool are_joined(Index a, Index b, Index step) const {
    bool has_b = false;
    for_each(a, step, [&](Index at, Index) { has_b = has_b || at == b; });
    return has_b;
  }

  /// the first of the lower components at which the contour just below the saddle arrives.
  CGAL_HTL_HOST_DEVICE Index first_of_contour(Index lower_component) const {
    Index first = lower_component;
    for_each(lower_component, 1, [&](Index at, Index) { first = at < first ? at : first; });
    return first;
  }

private:
  // The lower component at which the contour arc that arrives at a lower component leaves: each
  // step of the unfolding has exchanged two neighbours.
  CGAL_HTL_HOST_DEVICE static Index target(Index lower_component, Index step) {
    return lower_component >= step ? lower_component
                                   : (lower_component + 1 == step ? 0 : lower_component + 1);
  }
};

/// What one thread knows of a saddle.
struct Saddle_view
{
  const Mesh_view& mesh;
  Span<const Time> time;
  Index center;
  Ring ring; ///< of the center
  Span<Lower_component_arc> lower_components;

  CGAL_HTL_HOST_DEVICE Index number_of_lower_components() const {
    return static_cast<Index>(lower_components.size());
  }

  CGAL_HTL_HOST_DEVICE void find_lower_components() const {
    Index start = 0;
    while(is_lower(start) || !is_lower(ring.next(start)))
      ++start; // a later vertex before an earlier one
    Index p = start, found = 0;
    do {
      const Index q = ring.next(p);
      if(!is_lower(p) && is_lower(q))
        lower_components[found++] = {q, q, ring[q], no_index, no_index, 0, no_index, no_index, 0};
      else if(is_lower(q))
        lower_components[found - 1].last = q;
      p = q;
    } while(p != start);
  }

  /// walks the arcs in turns until all but one have arrived.
  CGAL_HTL_HOST_DEVICE void walk_arcs() const {
    const Index k = number_of_lower_components();
    for(Index i = 0; i < k; ++i)
      start_arc(i);
    Index arrived = 0;
    while(arrived + 1 < k)
      for(Index i = 0; i < k && arrived + 1 < k; ++i)
        if(lower_components[i].arrival == no_index && advance(lower_components[i]))
          ++arrived;
    settle_longest();
  }

  /// unfolds the saddle into k - 1 simple ones, and notes the handles: in step i the contour around
  /// lower components 0 .. i - 1 and the one around lower component i are cut and joined crosswise.
  /// If they are different contours, these meet: a handle; if not, a contour parts.
  CGAL_HTL_HOST_DEVICE void find_handles() const {
    for(Index i = 1; i < number_of_lower_components(); ++i) {
      const Cycle a = cycle(i - 1, i), b = cycle(i, i);
      if(a.has_lower_component)
        continue;
      const bool take_a = b.has_longest || (!a.has_longest && a.size <= b.size);
      lower_components[i].handle_start = take_a ? i - 1 : i;
      lower_components[i].handle_size = loop_size(lower_components[i].handle_start, i);
    }
  }

  /// calls `f` for the crossings of the handle at lower component `i`, one after the other.
  template <typename Function> CGAL_HTL_HOST_DEVICE void trace(Index i, const Function& f) const {
    trace_contour(lower_components[i].handle_start, i, f,
                  [&](Index leaving) { trace_arc(leaving, f); });
  }

  /// goes along the contour that arrives at a lower component when lower components 0 .. step - 1
  /// have been joined: calls `f` for the crossings in the star of the saddle, and `arc(i)` where
  /// the arc that leaves lower component i is.
  template <typename Function, typename Arc_function>
  CGAL_HTL_HOST_DEVICE void
  trace_contour(Index start, Index step, const Function& f, const Arc_function& arc) const {
    cycles().for_each(start, step, [&](Index at, Index leaving) {
      join(at, leaving, f);
      arc(leaving);
    });
  }

  /// calls `f` for the crossings from one lower component to the next over the gap between them, or
  /// back around all the lower components. From one to itself they are those of the contour just
  /// below the saddle; with those of the arcs, they are all of its contours.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void join(Index at, Index leaving, const Function& f) const {
    if(leaving == at + 1) {
      const Index end = lower_components[leaving].first;
      for(Index p = ring.next(lower_components[at].last); p != end; p = ring.next(p))
        f(Crossing{center, ring[p], smallest_ratio});
      return;
    }
    for(Index p = lower_components[at].last;; p = ring.previous(p)) {
      f(Crossing{ring[p], center, largest_ratio});
      if(p == lower_components[leaving].first)
        break;
    }
  }

  /// calls `f` for the crossings of the arc that leaves lower component `i`, one after the other.
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void trace_arc(Index i, const Function& f) const {
    Index left = ring[lower_components[i].first],
          right = ring[ring.previous(lower_components[i].first)];
    for(;;) {
      f(contour_crossing(left, right, time[left], time[right], time[center]));
      const Index apex = apex_ahead(left, right);
      if(apex == center)
        break;
      (is_earlier(apex, center) ? left : right) = apex;
    }
  }

  CGAL_HTL_HOST_DEVICE Contour_cycles cycles() const { return {lower_components}; }

private:
  // A contour, as it is when lower components 0 .. i - 1 have been joined.
  struct Cycle
  {
    Index size;
    bool has_lower_component, has_longest;
  };

  CGAL_HTL_HOST_DEVICE bool is_earlier(Index u, Index v) const {
    return arrival_key(time[u], u) < arrival_key(time[v], v);
  }
  CGAL_HTL_HOST_DEVICE bool is_lower(Index p) const { return is_earlier(ring[p], center); }

  CGAL_HTL_HOST_DEVICE void start_arc(Index i) const {
    Lower_component_arc& lower_component = lower_components[i];
    lower_component.left = ring[lower_component.first];
    lower_component.right = ring[ring.previous(lower_component.first)];
    lower_component.arc_size = 1;
  }

  CGAL_HTL_HOST_DEVICE Index apex_ahead(Index left, Index right) const {
    return after(mesh.ring(left), mesh.ring(right), left, right);
  }

  CGAL_HTL_HOST_DEVICE bool advance(Lower_component_arc& arc) const {
    const Index apex = apex_ahead(arc.left, arc.right);
    if(apex == center) {
      arc.arrival = lower_component_that_ends_at(arc.left);
      return true;
    }
    (is_earlier(apex, center) ? arc.left : arc.right) = apex;
    ++arc.arc_size;
    return false;
  }

  CGAL_HTL_HOST_DEVICE Index lower_component_that_ends_at(Index v) const {
    Index i = 0;
    while(ring[lower_components[i].last] != v)
      ++i;
    return i;
  }

  // The longest arc is the one that has not arrived, and is marked by its size.
  CGAL_HTL_HOST_DEVICE void settle_longest() const {
    Index longest = 0;
    std::uint64_t sum = 0; // of the lower components that are arrived at
    for(Index i = 0; i < number_of_lower_components(); ++i)
      if(lower_components[i].arrival == no_index)
        longest = i;
      else
        sum += lower_components[i].arrival;
    const std::uint64_t k = number_of_lower_components();
    lower_components[longest].arrival = static_cast<Index>(k * (k - 1) / 2 - sum);
    lower_components[longest].arc_size = no_index;
  }

  CGAL_HTL_HOST_DEVICE Cycle cycle(Index start, Index i) const {
    Cycle result = {0, false, false};
    cycles().for_each(start, i, [&](Index at, Index leaving) {
      result.has_lower_component = result.has_lower_component || at == i;
      result.has_longest = result.has_longest || lower_components[leaving].arc_size == no_index;
      result.size += lower_components[leaving].arc_size;
    });
    return result;
  }

  CGAL_HTL_HOST_DEVICE Index loop_size(Index start, Index i) const {
    Index size = 0;
    trace_contour(
        start, i, [&](const Crossing&) { ++size; },
        [&](Index leaving) { size += lower_components[leaving].arc_size; });
    return size;
  }
};

/// The saddles in the order of their times, and their lower components, one saddle after the other.
struct Saddle_arrays
{
  Mesh_view mesh;
  Span<const Time> time;
  Span<const Index> saddles;
  Span<const Index> begin; ///< by saddle, its first lower component
  Span<Lower_component_arc> lower_components;

  CGAL_HTL_HOST_DEVICE Saddle_view saddle(Index i) const {
    const Index v = saddles[i];
    return {
        mesh, time, v, mesh.ring(v), {lower_components.data() + begin[i], begin[i + 1] - begin[i]}};
  }
};

/// Counts the lower components of each saddle.
struct Count_lower_components
{
  Mesh_view mesh;
  Span<const Time> time;
  Span<const Index> saddles;
  Span<Index> number_of_lower_components;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    const std::uint64_t key = arrival_key(time[saddles[i]], saddles[i]);
    number_of_lower_components[i] = count_lower_components(
        mesh.ring(saddles[i]), [&](Index u) { return arrival_key(time[u], u) < key; });
  }
};

/// Walks the contours that meet at each saddle, and finds the handles.
struct Walk_contours
{
  Saddle_arrays arrays;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    const Saddle_view saddle = arrays.saddle(i);
    saddle.find_lower_components();
    saddle.walk_arcs();
    saddle.find_handles();
  }
};

/// Two different contours meet at a saddle: a handle. `loop` is the shorter of the two, just below
/// the saddle, with the earlier side on its left.
struct Handle_candidate
{
  Crossing_loop loop;
  Index saddle;
  Index foot_a, foot_b; ///< earlier neighbours of the saddle, within either contour
};

/// The fronts of a sweep. Each lies in a layer from the event, or the minimum, with which it begins
/// to the event with which it ends; layers are numbered from 1 in the order in which they begin.
struct Front_log
{
  std::vector<Front_event> events; ///< in the order of arrival
  std::vector<Index> layer;        ///< by vertex; where a front ends, that of the front, or of one
};

inline std::vector<double> times_in_steps(const std::vector<Time>& times) {
  std::vector<double> steps(times.size());
  std::transform(times.begin(), times.end(), steps.begin(),
                 [](Time time) { return double(time) / ticks_per_step; });
  return steps;
}

/// A handle that was found at a lower component of a saddle.
struct Found_handle
{
  Index saddle, lower_component;
  Index begin; ///< of its crossings
};

/// Walks the loops of the handles once more, and writes them.
struct Trace_handles
{
  Saddle_arrays arrays;
  Span<const Found_handle> handles;
  Span<Crossing> crossings;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    const Found_handle& handle = handles[i];
    Crossing* out = crossings.data() + handle.begin;
    arrays.saddle(handle.saddle).trace(handle.lower_component, [&](const Crossing& c) {
      *out++ = c;
    });
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_CONTOURS_H
