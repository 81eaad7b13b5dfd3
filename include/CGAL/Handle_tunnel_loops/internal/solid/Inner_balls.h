// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_INNER_BALLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_INNER_BALLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_ball.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// where the segment from a point leaves a ball of which the radius is `within` times that of a
/// given one, in which the point is; or the end of the segment.
inline Vector
exit_of_ball(const Inner_ball& ball, double within, const Vector& from, const Vector& end) {
  const Vector way = end - from, off = from - ball.centre;
  const double a = dot(way, way), b = dot(off, way),
               c = dot(off, off) - within * within * ball.radius * ball.radius;
  const double part = a > 0. ? (std::sqrt((std::max)(0., b * b - a * c)) - b) / a : 0.;
  return from + (std::max)(0., (std::min)(1., part)) * way;
}

/*!
Finds large balls inside: from a place on the surface along the normal to the middle of the solid.

The ball that touches the surface at that place first reaches to the opposite side. It shrinks until
it holds nothing of the surface, but for what is seen from its centre beside the place where it
touches: so that convex edges and noise don't make it small. Then it is pushed away from what is in
it. All of the way is inside.
*/
class Inner_balls
{
public:
  /// \p inward is 1 if the normals of a component look inside, -1 if not.
  Inner_balls(const Wall& wall, std::vector<int> inward)
      : wall_(wall)
      , inward_(std::move(inward)) {}

  /// the unit normal of a face that looks inside; nothing if it has none.
  std::optional<Vector> inward_normal(Index f) const {
    const Vector normal = wall_.normal(f);
    const double length = norm(normal);
    if(!(length > 0.))
      return std::nullopt;
    return (inward_[wall_.component(f)] / length) * normal;
  }

  /// the ball seen from a place on a face.
  Inner_ball operator()(const Vector& place, Index f) const {
    Inner_ball last = {place, 0.};
    follow(place, f, [&](const Inner_ball& ball) { last = ball; });
    return last;
  }

  /// the way from a place to the centre of its ball: the ends of segments that are inside but for
  /// the place itself.
  std::vector<Vector> way(const Vector& place, Index f) const {
    std::vector<Vector> way;
    follow(place, f, [&](const Inner_ball& ball) { way.push_back(ball.centre); });
    return way;
  }

  /// a larger ball, away from what is nearest to the centre of a ball no larger than given.
  Inner_ball pushed(const Inner_ball& ball) const {
    const Wall::Nearest touch = wall_.nearest(ball.centre, ball.radius, precision);
    if(touch.face == no_index || !(touch.distance > 0.))
      return ball;
    const Touching_ball larger =
        touching_ball(touch.point, (1. / touch.distance) * (ball.centre - touch.point), touch.face,
                      touch.distance);
    return {larger.ball.centre, larger.clearance()};
  }

private:
  // Two places where a ball touches are beside each other if they are seen at a smaller angle.
  static constexpr double cosine_beside = -0.17;
  // What is less far in is not told from what is on the surface of a ball.
  static constexpr double tolerance = 0.9;

  static constexpr double precision = 0.95; // of distances

  // A ball that touches at a place, and what is in it, if it holds anything.
  struct Touching_ball
  {
    Inner_ball ball;
    Wall::Nearest in_it;

    double clearance() const { return in_it.face == no_index ? ball.radius : in_it.distance; }
  };

  // Calls `f(ball)` for balls that are larger and larger, with their true radius.
  template <typename Function>
  void follow(const Vector& place, Index face, const Function& f) const {
    const std::optional<Vector> normal = inward_normal(face);
    if(!normal)
      return;
    constexpr int most_pushes = 4;
    constexpr double gain = 1.02;
    Touching_ball last = touching_ball(place, *normal, face, 0.);
    for(int i = 0; i < most_pushes; ++i) {
      const double radius = last.clearance();
      f(Inner_ball{last.ball.centre, radius});
      if(last.in_it.face == no_index || !(radius > 0.))
        return;
      const Vector away = (1. / radius) * (last.ball.centre - last.in_it.point);
      const Touching_ball pushed = touching_ball(last.in_it.point, away, last.in_it.face, radius);
      if(!(pushed.clearance() > gain * radius))
        return;
      last = pushed;
    }
  }

  // The ball that touches at a place, at least so large, which lies in the direction given.
  Touching_ball
  touching_ball(const Vector& place, const Vector& direction, Index f, double least) const {
    constexpr int most_steps = 24;
    const double way = wall_.free_way(place, direction, f, 0.5 * least);
    double radius =
        way < std::numeric_limits<double>::infinity() ? (std::max)(0.5 * way, least) : least;
    Touching_ball touching = {};
    for(int i = 0; i < most_steps; ++i) {
      touching.ball = {place + radius * direction, radius};
      touching.in_it = wall_.nearest(touching.ball.centre, tolerance * radius, precision);
      if(touching.in_it.face == no_index)
        break;
      const Vector to = touching.in_it.point - place;
      const double depth = dot(direction, to);
      const double smaller = depth > 0. ? dot(to, to) / (2. * depth) : radius;
      if(!(smaller < radius) || smaller <= least || is_beside(direction, smaller, to))
        break;
      radius = smaller;
    }
    return touching;
  }

  // Whether what is there seen from the place where a ball touches is beside that place.
  static bool is_beside(const Vector& direction, double radius, const Vector& to) {
    const Vector other = to - radius * direction; // from the centre
    return -dot(direction, other) > cosine_beside * norm(other);
  }

  const Wall& wall_;
  std::vector<int> inward_; // by component
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_INNER_BALLS_H
