// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_POLYLINE_SHAPE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_POLYLINE_SHAPE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Fitted_circle.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Plane_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Principal_axes.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How large, how flat and how round a closed polyline is; what it says is that of `Loop_shape`.
class Polyline_shape
{
  using Kernel = Simple_cartesian<double>;

public:
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;

  struct Circle
  {
    Point center;
    double diameter, deviation, out_of_roundness;
  };

  Bbox_3 box;
  double length = 0., deviation = 0.;
  Point center;
  Vector normal = NULL_VECTOR;
  std::optional<Circle> circle, best_circle;

  explicit Polyline_shape(const std::vector<Point>& points)
      : box(CGAL::bbox_3(points.begin(), points.end())) {
    CGAL_precondition(!points.empty());
    move_to_unit(points);
    measure();
    if(length > 0.) {
      find_plane();
      find_circles();
    }
    move_back();
  }

private:
  // Coordinates from -1 to 1: their squares are neither too large nor too small for numbers.
  void move_to_unit(const std::vector<Point>& points) {
    const auto half = [this](int i) { return box.max(i) / 2. - box.min(i) / 2.; };
    const auto middle = [this](int i) { return box.max(i) / 2. + box.min(i) / 2.; };
    origin_ = Point(middle(0), middle(1), middle(2));
    unit_ = (std::max)({half(0), half(1), half(2)});
    const double divisor = unit_ > 0. ? unit_ : 1.;
    for(const Point& p : points)
      places_.emplace_back((p.x() - origin_.x()) / divisor, (p.y() - origin_.y()) / divisor,
                           (p.z() - origin_.z()) / divisor);
  }

  template <typename Function> void for_each_segment(const Function& f) const {
    for(std::size_t i = 0; i < places_.size(); ++i) {
      const Vector &a = places_[i], &b = places_[i + 1 == places_.size() ? 0 : i + 1];
      f(a, b, std::sqrt((b - a).squared_length()));
    }
  }

  void measure() {
    Vector sum = NULL_VECTOR;
    for_each_segment([&](const Vector& a, const Vector& b, double size) {
      length += size;
      sum = sum + size * ((a + b) / 2.);
    });
    middle_ = length > 0. ? sum / length : places_.front();
  }

  // As the square of the length of a vector says how heavy its direction is: a segment is as heavy
  // as its middle, and along itself a twelfth of its length.
  template <typename Function> void for_each_moment(const Function& f) const {
    for_each_segment([&](const Vector& a, const Vector& b, double size) {
      f(std::sqrt(size) * ((a + b) / 2. - middle_));
      f(std::sqrt(size / 12.) * (b - a));
    });
  }

  void find_plane() {
    const auto [x, y, z] = Principal_axes::least_of_directions([&](const auto& f) {
      for_each_moment([&](const Vector& v) { f(Principal_axes::Vector{v.x(), v.y(), v.z()}); });
    });
    normal = Vector(x, y, z);
    Vector area = NULL_VECTOR;
    for_each_segment([&](const Vector& a, const Vector& b, double) {
      area = area + CGAL::cross_product(a - middle_, b - middle_);
    });
    if(area * normal < 0.)
      normal = -normal;
    for(const Vector& p : places_)
      deviation = (std::max)(deviation, std::abs((p - middle_) * normal));
  }

  // As they are seen along the normal, each once.
  std::vector<Fitted_circle::Point> points_of(const Plane_axes& plane) const {
    std::vector<Fitted_circle::Point> points;
    for(const Vector& p : places_)
      if(const auto q = plane.seen(p - middle_); points.empty() || q != points.back())
        points.push_back(q);
    return points;
  }

  // Where it bends by more than 0.03 degrees.
  static std::vector<Fitted_circle::Point>
  corners_among(const std::vector<Fitted_circle::Point>& points) {
    constexpr double sine = 5e-4;
    std::vector<Fitted_circle::Point> corners;
    for(std::size_t i = 0, n = points.size(); i < n; ++i) {
      const auto in = points[i] - points[(i + n - 1) % n], out = points[(i + 1) % n] - points[i];
      const double turn = in.x() * out.y() - in.y() * out.x();
      if(in * out <= 0. || turn * turn > sine * sine * in.squared_length() * out.squared_length())
        corners.push_back(points[i]);
    }
    return corners;
  }

  // The corners of a polygon around a bore lie on its circle. Of what has no corners all around, no
  // part counts more than another.
  void find_circles() {
    constexpr double tolerance = 0.01;
    const Plane_axes plane(normal);
    const std::vector<Fitted_circle::Point> points = points_of(plane);
    const std::vector<Fitted_circle::Point> corners = corners_among(points);
    const auto in_space = [&](const Fitted_circle& found) {
      const Vector c = middle_ + plane.in_space(found.center);
      return Circle{Point(c.x(), c.y(), c.z()), 2. * found.radius, found.deviation(),
                    found.out_of_roundness()};
    };
    const std::optional<Fitted_circle> around = Fitted_circle::around(corners);
    const bool is_corners_circle =
        around && length <= (1. + tolerance) * 2. * CGAL_PI * around->radius;
    best_circle = in_space(is_corners_circle ? *around : Fitted_circle::about_centroid(points));
    if(is_corners_circle && around->is_round() && deviation <= tolerance * around->radius)
      circle = best_circle;
  }

  Point in_space(const Vector& v) const {
    return {origin_.x() + unit_ * v.x(), origin_.y() + unit_ * v.y(), origin_.z() + unit_ * v.z()};
  }

  void move_back() {
    length *= unit_;
    deviation *= unit_;
    center = in_space(middle_);
    for(std::optional<Circle>* found : {&circle, &best_circle})
      if(*found) {
        (*found)->center = in_space((*found)->center - Point(ORIGIN));
        (*found)->diameter *= unit_;
        (*found)->deviation *= unit_;
      }
    places_.clear();
  }

  Point origin_;
  double unit_ = 1.; // of the places
  std::vector<Vector> places_;
  Vector middle_ = NULL_VECTOR; // the centroid
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_POLYLINE_SHAPE_H
