// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_PROJECTED_POINTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_PROJECTED_POINTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/exact_vectors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Points in space as they are seen along a direction, and exact predicates on them.

The points are vertices with double coordinates and midpoints of pairs of vertices, and are made as
they are asked for: nothing is stored. They are projected along (a, b, 1) to the plane of the first
two coordinates, that is to (x - a z, y - b z), so that the viewer is where z is large. Predicates
are evaluated in floating point with a bound of the error. Where that does not decide, they are
evaluated from close by, with each axis scaled to the points at hand, as one point far away or one
long axis would else leave nothing to see of the others; and at last exactly.
*/
class Projected_points
{
public:
  /// The direction (a, b, 1), where a and b are in [-1, 1].
  struct Direction
  {
    double a, b;
  };

  /// The sum of two vertices, hence twice as far out as the midpoint, which changes no predicate;
  /// and scaled by a power of two, so that no coordinate is larger than 1.
  struct Point
  {
    double x, y; ///< the projection; each is off by less than `position_error()`
    Vector space;
    Index u, v;
  };

  /// The vertices must outlive it.
  Projected_points(const std::vector<Vector>& vertices, const Direction& direction)
      : vertices_(vertices)
      , direction_(direction) {
    double largest = 0.;
    for(const Vector& p : vertices)
      for(double x : p)
        largest = (std::max)(largest, std::abs(x));
    const double scale = scale_for(largest);
    scale_of_all_ = {scale, scale, {scale, scale, scale}};
  }

  /// changes the direction. Points made before are of no use any more.
  void see_along(const Direction& direction) { direction_ = direction; }

  Point vertex(Index v) const { return midpoint(v, v); }

  Point midpoint(Index u, Index v) const {
    CGAL_precondition(u < vertices_.size() && v < vertices_.size());
    return midpoint(u, v, scale_of_all_);
  }

  static double position_error(const Point& p) {
    const Vector& v = p.space;
    return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}) * 0x1p-50 + 0x1p-1070;
  }

  /// the sense in which the projections of three points turn: 1 is counterclockwise.
  int turn(const Point& p, const Point& q, const Point& r) const {
    return sign([](const auto&... points) { return certain_turn(points...); },
                [&] { return exact_turn(p, q, r); }, p, q, r);
  }

  /// the same with r moved aside by (s, s^2) for an infinitesimal s; zero only if p and q are seen
  /// at one place.
  int turn_to_moved(const Point& p, const Point& q, const Point& r) const {
    const int sense = turn(p, q, r);
    return sense != 0 ? sense : turn_to_step(p, q);
  }

  /// the same with p and q moved aside.
  int turn_of_moved(const Point& p, const Point& q, const Point& r) const {
    const int sense = turn(p, q, r);
    return sense != 0 ? sense : -turn_to_step(p, q);
  }

  /// the sense in which the line from a to b, moved aside, is seen to cross that from p to q: 1 if
  /// q is to the left of it then, 0 if it does not cross. A line that is seen as a point crosses
  /// nothing.
  int crossing_of_moved(const Point& a, const Point& b, const Point& p, const Point& q) const {
    const int sense = turn_of_moved(a, b, q);
    return sense == turn_of_moved(a, b, p) || turn_to_moved(p, q, a) == turn_to_moved(p, q, b)
               ? 0
               : sense;
  }

  /// 1 if s lies on the side of the plane through p, q and r from which these are seen to turn
  /// counterclockwise; 0 if it lies on the plane.
  int side(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return sign([](const auto&... points) { return certain_side(points...); },
                [&] { return exact_side(p, q, r, s); }, p, q, r, s);
  }

private:
  // Powers of two for the coordinates of the projection, and of space.
  struct Scales
  {
    double x, y;
    Vector space;
  };

  // A power of two that makes coordinates up to the largest one smaller than 1/2.
  static double scale_for(double largest) {
    int exponent;
    std::frexp(largest, &exponent);
    return std::ldexp(1., (std::min)(-exponent - 1, 1000));
  }

  Point midpoint(Index u, Index v, const Scales& scales) const {
    const auto sum = [&](int d, double scale) {
      return scale * vertices_[u][d] + scale * vertices_[v][d];
    };
    Point p;
    p.u = u;
    p.v = v;
    for(int d = 0; d < 3; ++d)
      p.space[d] = sum(d, scales.space[d]);
    p.x = sum(0, scales.x) - direction_.a * sum(2, scales.x);
    p.y = sum(1, scales.y) - direction_.b * sum(2, scales.y);
    return p;
  }

  // The sign that `certain(points...)` tells, from close by if need be, or else `exact()`.
  template <typename Certain, typename Exact, typename... Points>
  int sign(const Certain& certain, const Exact& exact, const Points&... p) const {
    if(const int sign = certain(p...))
      return sign;
    const Scales scales = scales_of({&p...});
    const int sign = certain(close_up(p, scales)...);
    return sign != 0 ? sign : exact();
  }

  // ---- predicates that may be left undecided: 0

  // No coordinate is larger than 1.
  static int certain_turn(const Point& a, const Point& b, const Point& c) {
    const double x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
    const double size = (std::max)({std::abs(x1), std::abs(y1), std::abs(x2), std::abs(y2)});
    // Each difference is off by at most 2^-50, and no larger than 4.
    return certain_sign(x1 * y2 - x2 * y1, size * 0x1p-47 + 0x1p-98);
  }

  static int certain_side(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Vector u = b.space - a.space, v = c.space - a.space, w = d.space - a.space;
    double size = 0.;
    for(int i = 0; i < 3; ++i)
      size = (std::max)({size, std::abs(u[i]), std::abs(v[i]), std::abs(w[i])});
    // Each difference is off by at most 2^-51, and no larger than 2.
    return certain_sign(dot(cross(u, v), w), size * size * 0x1p-45 + 0x1p-95);
  }

  static int certain_sign(double value, double error) {
    return std::abs(value) <= error ? 0 : value > 0. ? 1 : -1;
  }

  // ---- from close by

  Scales scales_of(std::initializer_list<const Point*> points) const {
    Vector largest{0., 0., 0.};
    for(const Point* p : points)
      for(Index v : {p->u, p->v})
        for(int d = 0; d < 3; ++d)
          largest[d] = (std::max)(largest[d], std::abs(vertices_[v][d]));
    return {scale_for((std::max)(largest[0], largest[2])),
            scale_for((std::max)(largest[1], largest[2])),
            {scale_for(largest[0]), scale_for(largest[1]), scale_for(largest[2])}};
  }

  Point close_up(const Point& p, const Scales& scales) const { return midpoint(p.u, p.v, scales); }

  Exact_vector exact_difference(const Point& a, const Point& b) const {
    return (exact(vertices_[b.u]) + exact(vertices_[b.v])) -
           (exact(vertices_[a.u]) + exact(vertices_[a.v]));
  }

  // ... projected; the last coordinate is of no use then.
  Exact_vector exact_projected_difference(const Point& p, const Point& q) const {
    Exact_vector v = exact_difference(p, q);
    v[0] -= Exact_number(direction_.a) * v[2];
    v[1] -= Exact_number(direction_.b) * v[2];
    return v;
  }

  int exact_turn(const Point& p, const Point& q, const Point& r) const {
    const Exact_vector u = exact_projected_difference(p, q), v = exact_projected_difference(p, r);
    return sign_of(Exact_number(u[0] * v[1] - u[1] * v[0]));
  }

  // The sign of a coordinate of the projection of q, seen from that of p.
  int compare(const Point& p, const Point& q, double Point::*coordinate) const {
    const auto certain = [&](const Point& a, const Point& b) {
      return certain_sign(b.*coordinate - a.*coordinate, 0x1p-49);
    };
    const auto exact = [&] {
      return sign_of(exact_projected_difference(p, q)[coordinate == &Point::x ? 0 : 1]);
    };
    return sign(certain, exact, p, q);
  }

  // The turn from the line through p and q to an infinitesimal step (s, s^2).
  int turn_to_step(const Point& p, const Point& q) const {
    const int y = compare(p, q, &Point::y);
    return y != 0 ? -y : compare(p, q, &Point::x);
  }

  int exact_side(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return sign_of(
        dot(cross(exact_difference(p, q), exact_difference(p, r)), exact_difference(p, s)));
  }

  const std::vector<Vector>& vertices_;
  Direction direction_;
  Scales scale_of_all_; // the same for all coordinates
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_PROJECTED_POINTS_H
