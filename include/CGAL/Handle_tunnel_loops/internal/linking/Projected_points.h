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

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/exact_vectors.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Points in space as they are seen along a direction, and exact predicates on them.

The points are vertices with double coordinates, in the order in which they are given, and then
midpoints of pairs of vertices. They are projected along (a, b, 1) to the plane of the first two
coordinates, that is to (x - a z, y - b z), so that the viewer is where z is large. Predicates are
evaluated in floating point with a bound of the error, and again with rational numbers where the
bound does not decide.
*/
class Projected_points
{
public:
  /// The direction (a, b, 1), where a and b are multiples of 2^-10 in [-1, 1].
  struct Direction
  {
    double a, b;
  };

  Projected_points(const std::vector<Vector>& vertices, const Direction& direction)
      : Projected_points(Execution(), vertices, direction, 0) {}

  /// as above; there will be \p number_of_midpoints.
  Projected_points(Execution execution,
                   const std::vector<Vector>& vertices,
                   const Direction& direction,
                   std::size_t number_of_midpoints)
      : vertices_(vertices) {
    double largest = 0.;
    for(const Vector& p : vertices)
      for(double x : p)
        largest = (std::max)(largest, std::abs(x));
    int exponent;
    std::frexp(largest, &exponent);
    scale_ = std::ldexp(1., (std::min)(-exponent - 1, 1000));
    reserve(execution, vertices.size() + number_of_midpoints);
    see_along(execution, direction);
  }

  /// changes the direction, and forgets the midpoints.
  void see_along(Execution execution, const Direction& direction) {
    direction_ = direction;
    number_of_points_ = 0;
    add_midpoints(execution, vertices_.size(), [](std::size_t v) {
      return std::make_pair(static_cast<Index>(v), static_cast<Index>(v));
    });
  }
  void see_along(const Direction& direction) { see_along(Execution(), direction); }

  /// adds the midpoint of two vertices as the next point.
  void add_midpoint(Index u, Index v) {
    add_midpoints(Execution(), 1, [&](std::size_t) { return std::make_pair(u, v); });
  }

  /// adds n points, the midpoints of the pairs `ends(i)` of vertices.
  template <typename Ends>
  void add_midpoints(Execution execution, std::size_t n, const Ends& ends) {
    if(number_of_points_ + n > capacity_)
      reserve(execution, (std::max)(number_of_points_ + n, 2 * capacity_));
    for_each_index(execution, n, [&](std::size_t i) {
      const auto [u, v] = ends(i);
      CGAL_precondition(u < vertices_.size() && v < vertices_.size());
      points_[number_of_points_ + i] = midpoint(u, v);
    });
    number_of_points_ += n;
  }

  /// the projection of a point, scaled by a power of two; each coordinate is off by less than
  /// `position_error`.
  std::array<double, 2> position(Index p) const { return {points_[p].x, points_[p].y}; }

  static constexpr double position_error = 0x1p-51;

  /// the sense in which the projections of three points turn: 1 is counterclockwise.
  int turn(Index p, Index q, Index r) const {
    CGAL_precondition(p < number_of_points_ && q < number_of_points_ && r < number_of_points_);
    const Point &a = points_[p], &b = points_[q], &c = points_[r];
    const double x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
    const double size = (std::max)({std::abs(x1), std::abs(y1), std::abs(x2), std::abs(y2)});
    const double value = x1 * y2 - x2 * y1;
    // Each difference is off by at most 2^-50, and no larger than 4.
    if(std::abs(value) > size * 0x1p-47 + 0x1p-98)
      return value > 0. ? 1 : -1;
    return exact_turn(p, q, r);
  }

  /// the same with r moved aside by (s, s^2) for an infinitesimal s; zero only if p and q are seen
  /// at one place.
  int turn_to_moved(Index p, Index q, Index r) const {
    const int sense = turn(p, q, r);
    return sense != 0 ? sense : turn_to_step(p, q);
  }

  /// the same with p and q moved aside.
  int turn_of_moved(Index p, Index q, Index r) const {
    const int sense = turn(p, q, r);
    return sense != 0 ? sense : -turn_to_step(p, q);
  }

  /// 1 if s lies on the side of the plane through p, q and r from which these are seen to turn
  /// counterclockwise; 0 if it lies on the plane.
  int side(Index p, Index q, Index r, Index s) const {
    const Vector &a = points_[p].space, &b = points_[q].space, &c = points_[r].space,
                 &d = points_[s].space;
    const Vector u = b - a, v = c - a, w = d - a;
    double size = 0.;
    for(int i = 0; i < 3; ++i)
      size = (std::max)({size, std::abs(u[i]), std::abs(v[i]), std::abs(w[i])});
    const double value = dot(cross(u, v), w);
    // Each difference is off by at most 2^-51, and no larger than 2.
    if(std::abs(value) > size * size * 0x1p-45 + 0x1p-95)
      return value > 0. ? 1 : -1;
    return exact_side(p, q, r, s);
  }

private:
  // All of them are the sum of two vertices, hence twice as far out as they should be, which
  // changes no predicate; and scaled by a power of two, so that no coordinate is larger than 1.
  struct Point
  {
    double x, y; // the projection
    Vector space;
    Index u, v;
  };

  Point midpoint(Index u, Index v) const {
    Point p;
    p.u = u;
    p.v = v;
    for(int d = 0; d < 3; ++d)
      p.space[d] = scale_ * vertices_[u][d] + scale_ * vertices_[v][d];
    p.x = p.space[0] - direction_.a * p.space[2];
    p.y = p.space[1] - direction_.b * p.space[2];
    return p;
  }

  // The memory is left as it is, so that the threads that fill it are the first to touch it.
  void reserve(Execution execution, std::size_t capacity) {
    std::unique_ptr<Point[]> points(new Point[capacity]);
    for_each_index(execution, number_of_points_, [&](std::size_t i) { points[i] = points_[i]; });
    points_ = std::move(points);
    capacity_ = capacity;
  }

  Exact_vector exact_difference(Index p, Index q) const {
    const Point &a = points_[p], &b = points_[q];
    return (exact(vertices_[b.u]) + exact(vertices_[b.v])) -
           (exact(vertices_[a.u]) + exact(vertices_[a.v]));
  }

  // ... projected; the last coordinate is of no use then.
  Exact_vector exact_projected_difference(Index p, Index q) const {
    Exact_vector v = exact_difference(p, q);
    v[0] -= Exact_rational(direction_.a) * v[2];
    v[1] -= Exact_rational(direction_.b) * v[2];
    return v;
  }

  int exact_turn(Index p, Index q, Index r) const {
    const Exact_vector u = exact_projected_difference(p, q), v = exact_projected_difference(p, r);
    return sign_of(Exact_rational(u[0] * v[1] - u[1] * v[0]));
  }

  // The sign of a coordinate of the projection of q, seen from that of p.
  int compare(Index p, Index q, int coordinate, double difference) const {
    if(std::abs(difference) > 0x1p-49)
      return difference > 0. ? 1 : -1;
    return sign_of(exact_projected_difference(p, q)[coordinate]);
  }

  // The turn from the line through p and q to an infinitesimal step (s, s^2).
  int turn_to_step(Index p, Index q) const {
    const int y = compare(p, q, 1, points_[q].y - points_[p].y);
    return y != 0 ? -y : compare(p, q, 0, points_[q].x - points_[p].x);
  }

  int exact_side(Index p, Index q, Index r, Index s) const {
    return sign_of(
        dot(cross(exact_difference(p, q), exact_difference(p, r)), exact_difference(p, s)));
  }

  const std::vector<Vector>& vertices_;
  Direction direction_;
  double scale_; // a power of two that makes the coordinates smaller than 1/2
  std::unique_ptr<Point[]> points_;
  std::size_t number_of_points_ = 0, capacity_ = 0;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_PROJECTED_POINTS_H
