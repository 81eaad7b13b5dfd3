// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CLEARANCE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CLEARANCE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL::Handle_tunnel_loops::internal {

/// How large a ball fits around a point, and along a segment: distances to the faces, caps
/// included, but for rounding.
class Clearance
{
public:
  /// \p tolerance is how much less than a radius, as a part of it, the clearance may be where balls
  /// of that radius are said to fit.
  Clearance(const Face_tree& faces, double tolerance)
      : faces_(faces)
      , tolerance_(tolerance) {}

  double tolerance() const { return tolerance_; }

  /// the distance of a point to the surface, if it is less than \p most, or else that. Nothing is
  /// nearer than \p precision, at most 1, times as far: in the middle, much is about equally near.
  double at(const Vector& p, double most, double precision = 1.) const {
    double best = most * most;
    faces_.boxes().for_each_nearer(p, precision * precision * best, [&](Index f) {
      const Triangle t = faces_.triangle(f);
      const Vector way = nearest_point(p, t[0], t[1], t[2]) - p;
      best = (std::min)(best, dot(way, way));
      return precision * precision * best;
    });
    return std::sqrt(best);
  }

  /// a place beside a point, on the same side of the surface, where a ball of a radius fits, if
  /// some steps away from what is nearest lead to one.
  std::optional<Vector> with_room(Vector p, double radius) const {
    constexpr int most_steps = 24;
    constexpr double more = 1. + 1e-9;
    for(int k = 0; k < most_steps; ++k) {
      const std::optional<Vector> q = nearest(p, radius);
      if(!q)
        return p;
      const Vector way = p - *q;
      const double distance = norm(way);
      if(distance == 0.)
        return std::nullopt;
      p = *q + (more * radius / distance) * way;
    }
    return std::nullopt;
  }

  /// A point that is too close to the surface.
  using Narrow = std::optional<Vector>;

  /// whether balls of a radius fit all along a segment: if not, where one does not. On a piece of
  /// length l between points with this clearance r it is at least (r^2 - l^2 / 4)^(1/2), as squared
  /// distances to a point are convex; so pieces need not be looked at once they are short.
  Narrow narrow_place(const Vector& a, const Vector& b, double radius) const {
    for(const Vector* p : {&a, &b})
      if(at(*p, radius) < radius)
        return *p;
    return narrow_between(a, b, radius);
  }

  /// how far apart, as a part of the radius, ends may be at which balls fit, for balls to fit in
  /// between.
  double step_without_a_look() const { return 2. * std::sqrt(2. * tolerance_); }

  /// the same where balls fit at the ends.
  Narrow narrow_between(const Vector& a, const Vector& b, double radius) const {
    constexpr double tight = 2.; // in such places much is about equally far away
    const double half = 0.5 * norm(b - a);
    if(2. * half <= step_without_a_look() * radius)
      return std::nullopt;
    const Vector middle = 0.5 * (a + b);
    const double clearance = at(
        middle, half < tight * radius ? (std::min)(radius + half, tight * radius) : radius + half);
    if(clearance < radius)
      return middle;
    if(clearance >= radius + half)
      return std::nullopt;
    if(const Narrow narrow = narrow_between(a, middle, radius))
      return narrow;
    return narrow_between(middle, b, radius);
  }

private:
  // The nearest point of the surface, if it is nearer than a distance.
  std::optional<Vector> nearest(const Vector& p, double distance) const {
    double limit = distance * distance;
    std::optional<Vector> best;
    faces_.boxes().for_each_nearer(p, limit, [&](Index f) {
      const Triangle t = faces_.triangle(f);
      const Vector q = nearest_point(p, t[0], t[1], t[2]), way = q - p;
      if(const double square = dot(way, way); square < limit) {
        limit = square;
        best = q;
      }
      return limit;
    });
    return best;
  }

  const Face_tree& faces_;
  double tolerance_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CLEARANCE_H
