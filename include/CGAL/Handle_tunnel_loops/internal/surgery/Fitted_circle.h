// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_FITTED_CIRCLE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_FITTED_CIRCLE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The circle that fits points of a plane best.
struct Fitted_circle
{
  using Kernel = Simple_cartesian<double>;
  using Point = Kernel::Point_2;

  Point center;
  double radius;
  double deviation; ///< the largest distance of a point

  /// if the points are on it but for a hundredth of the radius, and go all around. Near linear.
  static std::optional<Fitted_circle> through(const std::vector<Point>& points) {
    constexpr double tolerance = 0.01;
    if(points.size() < 6)
      return std::nullopt;
    Fitted_circle circle = of_least_squares(points);
    if(!std::isfinite(circle.radius)) // they are on a line
      return std::nullopt;
    for(const Point& p : points)
      circle.deviation =
          (std::max)(circle.deviation,
                     std::abs(std::sqrt(CGAL::squared_distance(p, circle.center)) - circle.radius));
    const bool is_close = circle.deviation <= tolerance * circle.radius;
    return is_close && go_around(points, circle.center) ? std::optional(circle) : std::nullopt;
  }

private:
  // Of x^2 + y^2 - a x - b y - c, about the centroid.
  static Fitted_circle of_least_squares(const std::vector<Point>& points) {
    const double number = static_cast<double>(points.size());
    Kernel::Vector_2 sum(NULL_VECTOR);
    for(const Point& p : points)
      sum = sum + (p - ORIGIN);
    const Point middle = ORIGIN + sum / number;
    double xx = 0., xy = 0., yy = 0., xr = 0., yr = 0., r = 0.;
    for(const Point& p : points) {
      const double x = p.x() - middle.x(), y = p.y() - middle.y(), square = x * x + y * y;
      xx += x * x, xy += x * y, yy += y * y, xr += x * square, yr += y * square, r += square;
    }
    const double determinant = 2. * (xx * yy - xy * xy);
    const double x = (xr * yy - yr * xy) / determinant, y = (yr * xx - xr * xy) / determinant;
    return {Point(middle.x() + x, middle.y() + y), std::sqrt(r / number + x * x + y * y), 0.};
  }

  // As the corners of a hexagon do.
  static bool go_around(const std::vector<Point>& points, const Point& center) {
    constexpr double widest = CGAL_PI / 3. + 0.01;
    std::vector<double> angles;
    for(const Point& p : points)
      angles.push_back(arc_tangent(p.y() - center.y(), p.x() - center.x()));
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 2. * CGAL_PI);
    for(std::size_t i = 1; i < angles.size(); ++i)
      if(angles[i] - angles[i - 1] > widest)
        return false;
    return true;
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_FITTED_CIRCLE_H
