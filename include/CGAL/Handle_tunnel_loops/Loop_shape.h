// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_LOOP_SHAPE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_LOOP_SHAPE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Polyline_shape.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

/// \file Loop_shape.h
/// Measures the size, flatness and roundness of a loop.

namespace CGAL {

namespace Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

The size, flatness and roundness of a closed polyline such as a loop. Lengths are in the unit of the
coordinates. For a loop around a bore, these values describe the loop; for the diameter of the bore
itself, use `CGAL::round_bores()`.

\tparam Point a three-dimensional point
*/
template <typename Point> struct Loop_shape
{
  /// The vector type of the kernel of the points.
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

  /// A circle in the plane of the polyline.
  struct Circle
  {
    Point center;     ///< the center
    double diameter;  ///< the diameter
    double deviation; ///< the largest distance of a corner of the polyline to it, in the plane
    /// the largest distance of the polyline to the center less the smallest one, over the diameter:
    /// 0.18 for a square
    double out_of_roundness;
  };

  double length = 0.;   ///< the length of the polyline
  double diameter = 0.; ///< the diameter of a circle of that length
  Bbox_3 box;           ///< the bounding box of the polyline
  Point center;         ///< the centroid of the polyline, weighted by length
  /// the unit normal of the plane through the centroid that fits the polyline best in the sense of
  /// least squares. The polyline turns around it counterclockwise. It is the null vector if the
  /// length is 0.
  Vector normal;
  double deviation = 0.; ///< the largest distance of a point of the polyline to that plane
  /// the least-squares circle through the corners, if the polyline is nearly round: the corners lie
  /// on the circle up to one hundredth of its radius, no gap between them is wider than the sides
  /// of a hexagon, the polyline is flat up to the same tolerance, and it goes around once. Points
  /// at which the polyline is straight, seen along the normal, are not corners: around a coarse
  /// bore, the loop lies on a polygon, and the corners of the polygon lie on the circle.
  std::optional<Circle> circle;
  /// the circle that fits best, however round the polyline is, unless its length is 0: that through
  /// the corners, if no gap between them is wider than the sides of a hexagon and the polyline goes
  /// around once; otherwise about the centroid, at the mean distance.
  std::optional<Circle> best_circle;
};

} // namespace Handle_tunnel_loops

/*!
\ingroup PkgHandleTunnelLoopsRef

Measures a closed polyline. The result does not depend on the point at which the polyline begins. It
moves and scales with the polyline, up to rounding.

The complexity is linear, and near linear for polylines that are nearly round.

\tparam PointRange a range of three-dimensional points

\param points the points of the polyline; the first one is not repeated at the end. Coordinates are
  taken as doubles.

\return the shape of the polyline

\pre `points` is not empty, and all coordinates are finite.

\sa `round_bores()`
*/
template <typename PointRange>
auto loop_shape(const PointRange& points)
    -> Handle_tunnel_loops::Loop_shape<std::decay_t<decltype(*std::begin(points))>> {
  namespace impl = Handle_tunnel_loops::internal;
  using Shape = Handle_tunnel_loops::Loop_shape<std::decay_t<decltype(*std::begin(points))>>;
  using Point = std::decay_t<decltype(*std::begin(points))>;
  std::vector<impl::Polyline_shape::Point> places;
  for(const auto& p : points)
    places.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  const impl::Polyline_shape found(places);
  const auto point = [](const auto& p) { return Point(p.x(), p.y(), p.z()); };
  Shape shape;
  shape.length = found.length;
  shape.diameter = found.length / CGAL_PI;
  shape.box = found.box;
  shape.center = point(found.center);
  shape.normal = typename Shape::Vector(found.normal.x(), found.normal.y(), found.normal.z());
  shape.deviation = found.deviation;
  const auto circle = [&](const auto& c) {
    using Circle = typename Shape::Circle;
    return c ? std::optional<Circle>(
                   {point(c->center), c->diameter, c->deviation, c->out_of_roundness})
             : std::nullopt;
  };
  shape.circle = circle(found.circle);
  shape.best_circle = circle(found.best_circle);
  return shape;
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOP_SHAPE_H
