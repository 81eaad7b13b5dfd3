// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_CLIMB_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_CLIMB_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Walks uphill in the distance to the surface from the centre of a ball, in so many steps. Returns the
ball there, which holds the place where the walk began. `directions(k)` are unit vectors.

Where the middle is a sheet, its ridge is level: no way from what is nearest leads to where the
solid is wider, as from a lobe to the middle of a profile, but a step does. No step leaves the ball.
*/
template <typename Directions>
Inner_ball
climb(const Wall& wall, const Inner_ball& start, int most_steps, const Directions& directions) {
  constexpr double longest = 0.9, shortest = 0.1; // of the radius
  constexpr double precision = 0.95;
  Inner_ball ball = start;
  double step = longest * ball.radius;
  for(int k = 0; k < most_steps && step > shortest * ball.radius; ++k) {
    const Inner_ball before = ball;
    for(const Vector& direction : directions(k)) {
      const Vector p = before.centre + step * direction;
      if(!wall.is_within(p, (std::max)(ball.radius, norm(p - start.centre))))
        ball = {p, wall.nearest(p, before.radius + step, precision).distance};
    }
    step = ball.radius > before.radius ? (std::min)(2. * step, longest * ball.radius) : 0.5 * step;
  }
  return ball;
}

/// the same in the plane across a unit vector. Directions are turned from step to step, as a ridge
/// is narrow.
inline Inner_ball
climb_across(const Wall& wall, const Inner_ball& start, const Vector& tangent, int most_steps) {
  constexpr double golden_angle = 2.399963229728653, sixth_turn = 1.0471975511965976, most = 0.6;
  const Vector aside = std::abs(tangent[0]) < most ? Vector{1., 0., 0.} : Vector{0., 1., 0.},
               across = cross(tangent, aside), u = (1. / norm(across)) * across,
               v = cross(tangent, u);
  return climb(wall, start, most_steps, [&](int k) {
    std::array<Vector, 6> directions;
    for(int i = 0; i < 6; ++i) {
      const double angle = golden_angle * k + sixth_turn * i;
      directions[i] = cosine(angle) * u + sine(angle) * v;
    }
    return directions;
  });
}

/// the same in all directions.
inline Inner_ball climb_around(const Wall& wall, const Inner_ball& start, int most_steps) {
  constexpr double golden_angle = 2.399963229728653;
  constexpr int number = 12;
  return climb(wall, start, most_steps, [&](int k) {
    std::array<Vector, number> directions;
    for(int i = 0; i < number; ++i) { // on a spiral from pole to pole
      const double z = (2. * i + 1.) / number - 1., r = std::sqrt(1. - z * z),
                   angle = golden_angle * (i + k);
      directions[i] = {r * cosine(angle), r * sine(angle), z};
    }
    return directions;
  });
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_CLIMB_H
