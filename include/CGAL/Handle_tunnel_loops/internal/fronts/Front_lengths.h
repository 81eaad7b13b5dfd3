// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LENGTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LENGTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/saddles/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/support/rounded_product.h>

#include <cstdint>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A place in the unit of the mesh.
struct Point
{
  double x, y, z;
};

CGAL_HTL_HOST_DEVICE inline Point point_of(const Crossing& c, const Mesh_view& mesh) {
  const double* p = mesh.points.data() + 3 * std::size_t(c.left);
  const double* q = mesh.points.data() + 3 * std::size_t(c.right);
  return {p[0] + rounded_product(c.ratio, q[0] - p[0]),
          p[1] + rounded_product(c.ratio, q[1] - p[1]),
          p[2] + rounded_product(c.ratio, q[2] - p[2])};
}

CGAL_HTL_HOST_DEVICE inline double distance(const Point& p, const Point& q) {
  return rounded_length(q.x - p.x, q.y - p.y, q.z - p.z);
}

/// A curve from the first to the last of its crossings.
struct Measured_curve
{
  Point first = {}, last = {};
  double length = 0.;
  bool is_empty = true;

  CGAL_HTL_HOST_DEVICE void add(const Point& p) {
    if(is_empty)
      first = p;
    else
      length += distance(last, p);
    last = p;
    is_empty = false;
  }

  CGAL_HTL_HOST_DEVICE void add(const Measured_curve& other) {
    add(other.first);
    length += other.length;
    last = other.last;
  }

  CGAL_HTL_HOST_DEVICE double closed_length() const { return length + distance(last, first); }
};

/// Measures the arcs, one thread for each: these are long, and all fronts are made of them.
struct Measure_arcs
{
  Saddle_arrays saddles;
  Span<const Index> saddle_of_lower_component;
  Span<Measured_curve> arcs; ///< by lower component

  CGAL_HTL_HOST_DEVICE void operator()(Index lower_component) const {
    const Index saddle = saddle_of_lower_component[lower_component];
    Measured_curve arc;
    saddles.saddle(saddle).trace_arc(
        lower_component - saddles.begin[saddle],
        [&](const Crossing& c) { arc.add(point_of(c, saddles.mesh)); });
    arcs[lower_component] = arc;
  }
};

/// The fronts that meet or part in one step of the unfolding of a saddle. Two meet and go on as the
/// first one above, or the first one below parts.
struct Linked_fronts
{
  std::uint64_t do_meet;     ///< zero or one; no byte is without a value
  double below[2], above[2]; ///< lengths, in the unit of the mesh
};

/// Measures them, for the step at each lower component but the first ones.
struct Measure_links
{
  Saddle_arrays saddles;
  Span<const Index> saddle_of_lower_component;
  Span<const Measured_curve> arcs;
  Span<Linked_fronts> fronts;

  CGAL_HTL_HOST_DEVICE void operator()(Index lower_component) const {
    const Index saddle = saddle_of_lower_component[lower_component],
                i = lower_component - saddles.begin[saddle];
    if(i == 0)
      return;
    Linked_fronts& f = fronts[lower_component];
    f.do_meet = !saddles.saddle(saddle).cycles().are_joined(i - 1, i, i);
    f.below[0] = length(saddle, i - 1, i);
    f.below[1] = f.do_meet ? length(saddle, i, i) : 0.;
    f.above[0] = length(saddle, i - 1, i + 1);
    f.above[1] = f.do_meet ? 0. : length(saddle, i, i + 1);
  }

private:
  CGAL_HTL_HOST_DEVICE double length(Index saddle, Index start, Index step) const {
    Measured_curve front;
    saddles.saddle(saddle).trace_contour(
        start, step, [&](const Crossing& c) { front.add(point_of(c, saddles.mesh)); },
        [&](Index i) { front.add(arcs[saddles.begin[saddle] + i]); });
    return front.closed_length();
  }
};

/// Measures the fronts that close, just below the maxima.
struct Measure_closings
{
  Mesh_view mesh;
  Span<const Index> maxima;
  Span<double> lengths;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    Measured_curve front;
    for(const Index u : mesh.ring(maxima[i]))
      front.add(point_of({u, maxima[i], largest_ratio}, mesh));
    lengths[i] = front.closed_length();
  }
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LENGTHS_H
