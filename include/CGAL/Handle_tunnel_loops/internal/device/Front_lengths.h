// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FRONT_LENGTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FRONT_LENGTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Contours.h>

#include <cmath>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// Adds up the length of a closed curve from its crossings.
class Curve_length
{
public:
  CGAL_HTL_HOST_DEVICE explicit Curve_length(const Mesh_view& mesh)
      : points_(mesh.points) {}

  CGAL_HTL_HOST_DEVICE void add(const Crossing& c) {
    const Point p = position(c);
    if(is_empty_)
      first_ = p;
    else
      sum_ += distance(last_, p);
    last_ = p;
    is_empty_ = false;
  }

  CGAL_HTL_HOST_DEVICE double closed() const { return sum_ + distance(last_, first_); }

private:
  struct Point
  {
    double x, y, z;
  };

  CGAL_HTL_HOST_DEVICE Point position(const Crossing& c) const {
    const double* p = points_.data() + 3 * std::size_t(c.left);
    const double* q = points_.data() + 3 * std::size_t(c.right);
    return {p[0] + c.ratio * (q[0] - p[0]), p[1] + c.ratio * (q[1] - p[1]),
            p[2] + c.ratio * (q[2] - p[2])};
  }

  CGAL_HTL_HOST_DEVICE static double distance(const Point& p, const Point& q) {
    const double x = q.x - p.x, y = q.y - p.y, z = q.z - p.z;
    return std::sqrt(x * x + y * y + z * z);
  }

  Span<const double> points_;
  Point first_ = {0., 0., 0.}, last_ = {0., 0., 0.};
  double sum_ = 0.;
  bool is_empty_ = true;
};

/// The fronts that meet or part in one step of the unfolding of a saddle. Two meet and go on as the
/// first one above, or the first one below parts.
struct Linked_fronts
{
  bool do_meet;
  double below[2], above[2]; ///< lengths, in the unit of the mesh
};

/// Measures them, for the step at each wedge but the first ones.
struct Measure_links
{
  Saddle_arrays saddles;
  Span<const Index> saddle_of_wedge;
  Span<Linked_fronts> fronts;

  CGAL_HTL_HOST_DEVICE void operator()(Index wedge) const {
    const Saddle_view view = saddles.saddle(saddle_of_wedge[wedge]);
    const Index i = wedge - saddles.begin[saddle_of_wedge[wedge]];
    if(i == 0)
      return;
    Linked_fronts& f = fronts[wedge];
    f.do_meet = !view.cycles().are_joined(i - 1, i, i);
    f.below[0] = length(view, i - 1, i);
    f.below[1] = f.do_meet ? length(view, i, i) : 0.;
    f.above[0] = length(view, i - 1, i + 1);
    f.above[1] = f.do_meet ? 0. : length(view, i, i + 1);
  }

private:
  CGAL_HTL_HOST_DEVICE double length(const Saddle_view& view, Index start, Index step) const {
    Curve_length sum(saddles.mesh);
    view.trace_contour(start, step, [&](const Crossing& c) { sum.add(c); });
    return sum.closed();
  }
};

/// Measures the fronts that close, just below the maxima.
struct Measure_closings
{
  Mesh_view mesh;
  Span<const Index> maxima;
  Span<double> lengths;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    Curve_length sum(mesh);
    for(const Index u : mesh.ring(maxima[i]))
      sum.add({u, maxima[i], largest_ratio});
    lengths[i] = sum.closed();
  }
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_FRONT_LENGTHS_H
