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
/// How large, how flat and how round a loop is.

namespace CGAL {

namespace Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

How large, how flat and how round a closed polyline is, such as a loop. Lengths are in the unit of
the coordinates. Of a loop that goes around a bore this says how the loop runs: the diameter of the
bore itself is that of its wall, see `CGAL::round_bores()`.

\tparam Point a three-dimensional point
*/
template <typename Point> struct Loop_shape
{
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;

  /// A circle in the plane.
  struct Circle
  {
    Point center;
    double diameter;
    double deviation; ///< the largest distance of a corner of the polyline from it, in the plane
  };

  double length = 0.;   ///< of the polyline
  double diameter = 0.; ///< of a circle of that length
  Bbox_3 box;           ///< the bounding box
  Point center;         ///< the centroid of the polyline, each part of it as heavy as it is long
  /// of length 1: that of the plane through the centroid that is nearest to the polyline in the
  /// sense of least squares. The polyline turns around it counterclockwise. The null vector if the
  /// length is 0.
  Vector normal;
  double deviation = 0.; ///< the largest distance of a point of the polyline from that plane
  /// that of least squares through the corners, if they are on it but for a hundredth of its
  /// radius, leave no gap that is wider than that of a hexagon, and if the polyline is flat up to
  /// as much and goes around once. Points at which it goes straight on, seen along the normal, are
  /// no corners: around a coarse bore it lies on a polygon, and the corners are on the circle.
  std::optional<Circle> circle;
};

} // namespace Handle_tunnel_loops

/*!
\ingroup PkgHandleTunnelLoopsRef

measures a closed polyline. The result does not depend on where the polyline begins, and moves and
grows with it, but for rounding.

The complexity is linear, and near linear where it is nearly round.

\tparam PointRange a range of three-dimensional points
\param points those of the polyline; the first one is not repeated at the end. Coordinates are
  taken as doubles.

\pre there is at least one point, and coordinates are finite.

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
  if(found.circle)
    shape.circle = typename Shape::Circle{point(found.circle->center), found.circle->diameter,
                                          found.circle->deviation};
  return shape;
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOP_SHAPE_H
