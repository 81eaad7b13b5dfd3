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
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Nothing of the surface is nearer to its centre than its radius.
struct Free_ball
{
  Vector place;
  double radius;
};

/// whether two places, and so the way between them, are well within a ball.
inline bool are_well_within(const Free_ball& ball, const Vector& a, const Vector& b) {
  constexpr double part = 0.5;
  return (std::max)(norm(a - ball.place), norm(b - ball.place)) < part * ball.radius;
}

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

  /// What of the surface is nearest to a point.
  struct Touch
  {
    Index face;
    Vector point;
    double distance;
  };

  /// if it is nearer than a distance.
  std::optional<Touch> nearest(const Vector& p, double distance) const {
    double limit = distance * distance;
    std::optional<Touch> best;
    faces_.boxes().for_each_nearer(p, limit, [&](Index f) {
      const Triangle t = faces_.triangle(f);
      const Vector q = nearest_point(p, t[0], t[1], t[2]), way = q - p;
      if(const double square = dot(way, way); square < limit) {
        limit = square;
        best = {f, q, std::sqrt(square)};
      }
      return limit;
    });
    return best;
  }

  /// A place, how much room there is, and points of the surface, in other directions each, that are
  /// about as near.
  struct Ridge
  {
    static constexpr std::size_t most_touched = 4;
    Vector place;
    double room = 0.;
    std::array<Vector, most_touched> touched = {};
    std::size_t size = 0;
  };

  static constexpr int most_steps = 24;

  /// where some steps uphill lead from a point, until there is room for a radius: away from all
  /// that was found to be near. (Between walls that converge, the way away from the nearer only
  /// leads to the other.) No wall is crossed.
  Ridge uphill(const Vector& from, double radius, int steps = most_steps) const {
    return uphill(from, radius, steps, [](const Vector& way) { return way; });
  }

  /// the same in the plane across a direction: a ball in a window has more room before it.
  Ridge uphill_across(const Vector& direction, const Vector& from, double radius) const {
    const Vector axis = unit(direction);
    return uphill(from, radius, most_steps,
                  [&](const Vector& way) { return way - dot(way, axis) * axis; });
  }

  /// a ball beside a point that has a radius or more, if steps uphill lead to one.
  std::optional<Free_ball> with_room(const Vector& p, double radius, int steps = most_steps) const {
    const Ridge ridge = uphill(p, radius, steps);
    return ridge.room >= radius ? std::optional(Free_ball{ridge.place, ridge.room}) : std::nullopt;
  }

  /// the same, with more room if that can be: balls that only just fit around an edge have to be
  /// very close together.
  std::optional<Free_ball> with_more_room(const Vector& p, double radius) const {
    constexpr double more = 1.3;
    const Ridge ridge = uphill(p, more * radius, most_steps / 2);
    return ridge.room >= radius ? std::optional(Free_ball{ridge.place, ridge.room})
                                : with_room(p, radius);
  }

  /// larger and larger balls uphill from one, up to a radius, each beside the one before.
  std::vector<Free_ball> risen(Free_ball ball, double most) const {
    constexpr double growth = 2.; // steps uphill are shorter than the ball that they begin in
    std::vector<Free_ball> balls;
    while(ball.radius < most) {
      const auto larger = with_room(ball.place, (std::min)(growth * ball.radius, most));
      if(!larger)
        break;
      ball = {larger->place, at(larger->place, most)};
      balls.push_back(ball);
    }
    return balls;
  }

  /// a ball around a point, as large as fits, or larger than a radius.
  Free_ball ball_at(const Vector& p, double radius) const {
    constexpr double enough = 1.5;
    return {p, at(p, enough * radius)};
  }

  /// how large balls are at least that fit all along the segment between two. (Squared distances to
  /// a point, less that along the segment, are linear: so the least of them is concave, and as
  /// large as between its ends at least.)
  static double least_between(const Free_ball& a, const Free_ball& b) {
    const Vector way = b.place - a.place;
    const double first = a.radius * a.radius, more = b.radius * b.radius - first,
                 square = dot(way, way);
    if(std::abs(more) >= square)
      return (std::min)(a.radius, b.radius);
    const double ratio = 0.5 * (1. - more / square);
    return std::sqrt((std::max)(0., first - ratio * ratio * square));
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
    if(half > radius && is_free_of_faces(a.place, b.place, radius))
      return std::nullopt;
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
  // Between two balls of a radius, or larger ones, without a look at the surface.
  bool is_free_between(const Free_ball& a, const Free_ball& b, double radius) const {
    return norm(b.place - a.place) <= std::abs(b.radius - a.radius) ||
           least_between(a, b) >= (1. - tolerance_) * radius;
  }

  // The same by the faces around, if these are few, as beside a long way within a thin wall.
  bool is_free_of_faces(const Vector& a, const Vector& b, double radius) const {
    constexpr std::size_t many = 32; // more are quicker told by pieces of the way
    std::array<Index, many> faces;
    std::size_t size = 0;
    bool are_many = false;
    const double reach = 0.5 * norm(b - a) + radius;
    faces_.boxes().for_each_nearer(0.5 * (a + b), reach * reach, [&](Index f) {
      are_many = size == many;
      if(!are_many)
        faces[size++] = f;
      return are_many ? -1. : reach * reach;
    });
    const double least = (1. - tolerance_) * radius;
    return !are_many && std::all_of(faces.begin(), faces.begin() + size, [&](Index f) {
      return is_away(faces_.triangle(f), a, b - a, least * least);
    });
  }

  // Whether a segment is so far from a triangle, as a square: along it, the squared distance is
  // convex, and so nowhere below its tangents.
  static bool is_away(const Triangle& t, const Vector& from, const Vector& way, double square) {
    constexpr int most_tangents = 16;
    struct Tangent
    {
      double at, value, slope;
    };
    const auto tangent = [&](double at) {
      const Vector p = from + at * way, off = p - nearest_point(p, t[0], t[1], t[2]);
      return Tangent{at, dot(off, off), 2. * dot(off, way)};
    };
    Tangent low = tangent(0.), high = tangent(1.);
    if((std::min)(low.value, high.value) < square)
      return false;
    for(int i = 0; i < most_tangents; ++i) {
      if(low.slope >= 0. || high.slope <= 0.)
        return true;
      const double at = (low.value - high.value - low.slope * low.at + high.slope * high.at) /
                        (high.slope - low.slope);
      if(low.value + low.slope * (at - low.at) >= square)
        return true;
      const Tangent middle = tangent((std::min)((std::max)(at, low.at), high.at));
      if(middle.value < square)
        return false;
      (middle.slope < 0. ? low : high) = middle;
    }
    return false;
  }

  template <typename Flatten>
  Ridge uphill(const Vector& from, double radius, int steps, const Flatten& flatten) const {
    constexpr double enough = 1.5, longest = 0.75, least_slope = 0.005;
    const double wanted = (1. + 0.125 * tolerance_) * radius;
    Ridge ridge;
    ridge.place = from;
    for(int k = 0;; ++k) {
      const std::optional<Touch> touch = nearest(ridge.place, enough * radius);
      ridge.room = touch ? touch->distance : enough * radius;
      if(ridge.room >= radius || ridge.room == 0. || k == steps)
        break;
      const Vector away = away_from(*touch, wanted, ridge, flatten);
      const double slope = norm(away);
      if(slope < least_slope)
        break;
      // No farther than what is known to be free.
      const double step = (std::min)(longest * ridge.room, (wanted - ridge.room) / slope);
      ridge.place = ridge.place + (step / slope) * away;
    }
    return ridge;
  }

  // A direction by which all that is nearer than a distance comes farther away, among it what is
  // nearest now; the faster the longer it is.
  template <typename Flatten>
  static Vector
  away_from(const Touch& touch, double distance, Ridge& ridge, const Flatten& flatten) {
    constexpr double alike = 0.95;
    std::array<Vector, Ridge::most_touched> away;
    const Vector first = (1. / touch.distance) * (ridge.place - touch.point);
    std::size_t left = 0;
    for(std::size_t i = 0; i < ridge.size; ++i) {
      const Vector way = ridge.place - ridge.touched[i];
      const double length = norm(way);
      if(length < distance && dot(way, first) < alike * length && left + 1 < away.size()) {
        ridge.touched[left] = ridge.touched[i];
        away[left++] = flatten((1. / length) * way);
      }
    }
    ridge.touched[left] = touch.point;
    away[left++] = flatten(first);
    ridge.size = left;
    return shortest_in_hull(away, left);
  }

  // Of the convex hull of some vectors, about (Gilbert): going along it leads in the direction of
  // each of them, by its own length at least.
  template <std::size_t n>
  static Vector shortest_in_hull(const std::array<Vector, n>& vectors, std::size_t size) {
    constexpr int most_rounds = 16;
    constexpr double tolerance = 0.01;
    Vector shortest = vectors[size - 1];
    for(int round = 0; round < most_rounds; ++round) {
      std::size_t best = 0;
      for(std::size_t i = 1; i < size; ++i)
        if(dot(shortest, vectors[i]) < dot(shortest, vectors[best]))
          best = i;
      const Vector way = vectors[best] - shortest;
      const double square = dot(way, way), slope = -dot(shortest, way);
      if(square == 0. || slope <= tolerance * dot(shortest, shortest))
        break;
      shortest = shortest + (std::min)(1., slope / square) * way;
    }
    return shortest;
  }

  const Face_tree& faces_;
  double tolerance_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CLEARANCE_H
