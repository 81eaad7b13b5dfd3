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

/// Nothing of the surface is nearer to its centre than its radius.
struct Free_ball
{
  Vector place;
  double radius;
};

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

  /// a ball beside a point, on the same side of the surface, that has a radius or more, if some
  /// steps away from what is nearest lead to one.
  std::optional<Free_ball> with_room(Vector p, double radius, int most_steps = 24) const {
    constexpr int few_steps = 6;
    constexpr double rounding = 1e-9, enough = 1.5, most_growth = 1.75;
    for(int k = 0; k < most_steps; ++k) {
      const std::optional<Vector> q = nearest(p, enough * radius);
      if(!q)
        return Free_ball{p, enough * radius};
      const Vector way = p - *q;
      const double distance = norm(way);
      if(distance >= radius)
        return Free_ball{p, distance};
      if(distance == 0.)
        return std::nullopt;
      // Between walls at an angle, steps become ever smaller, unless they lead a little too far.
      // They are shorter than what is known to be free, so that no wall is crossed.
      const double more = k < few_steps ? rounding : 0.5 * tolerance_;
      p = *q + (std::min)(most_growth, (1. + more) * radius / distance) * way;
    }
    return std::nullopt;
  }

  /// a ball around a point, as large as fits, or larger than a radius.
  Free_ball ball_at(const Vector& p, double radius) const {
    constexpr double enough = 1.5;
    return {p, at(p, enough * radius)};
  }

  /// whether balls of a radius fit all along a segment between two that have it: if not, a point
  /// that is too close to the surface.
  std::optional<Vector>
  narrow_between(const Free_ball& a, const Free_ball& b, double radius) const {
    constexpr double tight = 2.; // in such places much is about equally far away
    if(is_free_between(a, b, radius))
      return std::nullopt;
    const Vector middle = 0.5 * (a.place + b.place);
    const double half = 0.5 * norm(b.place - a.place);
    const Free_ball ball = {middle, at(middle, half < tight * radius
                                                   ? (std::min)(radius + half, tight * radius)
                                                   : radius + half)};
    if(ball.radius < radius)
      return middle;
    if(const auto narrow = narrow_between(a, ball, radius))
      return narrow;
    return narrow_between(ball, b, radius);
  }

private:
  // Squared distances to a point, less that along the segment, are linear: so the least of them is
  // concave, and as large as between its ends at least.
  bool is_free_between(const Free_ball& a, const Free_ball& b, double radius) const {
    const Vector way = b.place - a.place;
    const double first = a.radius * a.radius, more = b.radius * b.radius - first,
                 square = dot(way, way), least = (1. - tolerance_) * radius;
    if(std::abs(more) >= square)
      return true;
    const double ratio = 0.5 * (1. - more / square);
    return first - ratio * ratio * square >= least * least;
  }

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
