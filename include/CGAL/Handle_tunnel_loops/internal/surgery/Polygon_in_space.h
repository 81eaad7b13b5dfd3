// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_POLYGON_IN_SPACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_POLYGON_IN_SPACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A closed polygon in space that is to be filled by triangles.
struct Polygon_in_space
{
  std::vector<Surgery_mesh::Point> points;
  /// outer normals of the faces beyond the sides, from each point to the next one, which the
  /// triangles should continue; those without a length do not count. Or none at all.
  std::vector<Simple_cartesian<double>::Vector_3> normals_beyond = {};
  /// the third corners of the same faces, or none at all.
  std::vector<Surgery_mesh::Point> corners_beyond = {};
  /// whether the triangles should continue these faces; or stand on them, at right angles if that
  /// can be, outside of them, or inside.
  enum At_sides { CONTINUED, OUTSIDE, INSIDE };
  At_sides at_sides = CONTINUED;
  /// whether two points are joined by an edge elsewhere already.
  std::function<bool(std::size_t, std::size_t)> are_joined = {};

  std::size_t size() const { return points.size(); }
};

/// The points of a polygon, to size 1, so that nothing is too small or too large; and how they lie.
/// All this is rounded.
struct Scaled_polygon
{
  using Point = Simple_cartesian<double>::Point_3;
  using Vector = Simple_cartesian<double>::Vector_3;

  explicit Scaled_polygon(const Polygon_in_space& polygon) {
    if(polygon.size() < 3)
      return;
    origin_ = polygon.points.front();
    for(const Surgery_mesh::Point& p : polygon.points)
      for(int axis = 0; axis < 3; ++axis)
        size_ = (std::max)(size_, std::abs(p[axis] / 2. - origin_[axis] / 2.));
    if(!(size_ > 0.) || !std::isfinite(size_))
      return;
    Vector sum(NULL_VECTOR);
    for(const Surgery_mesh::Point& p : polygon.points) {
      points.push_back(scaled(p));
      sum = sum + (points.back() - ORIGIN);
    }
    center = ORIGIN + sum / static_cast<double>(points.size());
    for(std::size_t i = 0; i < points.size(); ++i)
      normal = normal +
               CGAL::cross_product(points[i] - center, points[(i + 1) % points.size()] - center);
  }

  /// whether there are at least three points, not all the same.
  bool is_good() const { return !points.empty(); }

  /// where another point is then.
  Point scaled(const Surgery_mesh::Point& p) const {
    const auto from_origin = [&](int axis) { return (p[axis] / 2. - origin_[axis] / 2.) / size_; };
    return {from_origin(0), from_origin(1), from_origin(2)};
  }

  /// whether all points lie on a plane, but for a part of the size.
  bool is_flat(double most_height = tolerance) const {
    return is_good() && std::all_of(points.begin(), points.end(),
                                    [&](const Point& p) { return is_level(p, most_height); });
  }

  /// whether a point lies on the plane of the others, if they have one.
  bool is_level(const Point& p, double most_height = tolerance) const {
    const double length = std::sqrt(normal.squared_length());
    return length > 0. && std::abs(normal * (p - center)) <= most_height * length;
  }

  static constexpr double tolerance = 1e-6; ///< of the size: coordinates may have been floats

  std::vector<Point> points;
  Point center = Point(ORIGIN);
  Vector normal = Vector(NULL_VECTOR); ///< as long as twice the area

private:
  Surgery_mesh::Point origin_ = Surgery_mesh::Point(ORIGIN);
  double size_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_POLYGON_IN_SPACE_H
