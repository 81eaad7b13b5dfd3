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
#include <limits>
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
  double nearest, furthest; ///< the distances of points from the center

  double deviation() const { return (std::max)(furthest - radius, radius - nearest); }
  double out_of_roundness() const { return (furthest - nearest) / (2. * radius); }

  /// whether the points are on it but for a hundredth of the radius.
  bool is_round() const { return deviation() <= 0.01 * radius; }

  /// if the points go all around. Near linear.
  static std::optional<Fitted_circle> around(const std::vector<Point>& points) {
    if(points.size() < 6)
      return std::nullopt;
    Fitted_circle circle = of_least_squares(points);
    if(!std::isfinite(circle.radius) || !go_around(points, circle.center)) // or they are on a line
      return std::nullopt;
    circle.measure(points, [&](std::size_t i) { return points[i]; });
    return circle;
  }

  /// about the centroid of a closed polyline, at the mean distance. Linear.
  static Fitted_circle about_centroid(const std::vector<Point>& polyline) {
    const auto side = [&](std::size_t i) {
      return Kernel::Segment_2(polyline[i], polyline[i + 1 == polyline.size() ? 0 : i + 1]);
    };
    // By Simpson's rule, with sides in parts: by that, a side that is seen at a right angle is off
    // by less than 1e-5.
    const auto mean = [&](const auto& f, auto sum) {
      constexpr int parts = 8;
      double length = 0.;
      for(std::size_t i = 0; i < polyline.size(); ++i) {
        const Kernel::Segment_2 whole = side(i);
        const double size = std::sqrt(whole.squared_length());
        for(int k = 0; k <= 2 * parts; ++k) {
          const double weight = k == 0 || k == 2 * parts ? 1. : k % 2 == 0 ? 2. : 4.;
          const Point p = whole.source() + k / (2. * parts) * whole.to_vector();
          sum = sum + weight * size / (6. * parts) * f(p);
        }
        length += size;
      }
      return sum / length;
    };
    Fitted_circle circle{Point(ORIGIN), 0., 0., 0.};
    circle.center =
        ORIGIN + mean([](const Point& p) { return p - ORIGIN; }, Kernel::Vector_2(NULL_VECTOR));
    circle.radius = mean([&](const Point& p) { return distance(p, circle.center); }, 0.);
    circle.measure(polyline, side);
    return circle;
  }

private:
  template <typename Part> static double distance(const Part& part, const Point& p) {
    return std::sqrt(CGAL::squared_distance(part, p));
  }

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
    return {Point(middle.x() + x, middle.y() + y), std::sqrt(r / number + x * x + y * y), 0., 0.};
  }

  // The furthest of some points, and the nearest of what `part(i)` gives for each.
  template <typename Function>
  void measure(const std::vector<Point>& points, const Function& part) {
    nearest = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < points.size(); ++i) {
      furthest = (std::max)(furthest, distance(points[i], center));
      nearest = (std::min)(nearest, distance(part(i), center));
    }
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
