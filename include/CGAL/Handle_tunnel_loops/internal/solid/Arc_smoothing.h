// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_ARC_SMOOTHING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_ARC_SMOOTHING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/climb.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// whether no segment between balls one after the other meets the surface.
inline bool is_line_free(const Wall& wall, const std::vector<Inner_ball>& line) {
  for(std::size_t i = 1; i < line.size(); ++i)
    if(wall.meets(line[i - 1].centre, line[i].centre))
      return false;
  return true;
}

/*!
Draws the arcs of a skeleton as a person would: smooth, and in the middle.

Each bend stays within a part of its ball, so that a smooth arc is inside if its bends are close
together; and is moved to the middle across the arc. Where an arc still leaves the solid, bends are
left as they were.
*/
class Arc_smoothing
{
public:
  using Balls = std::vector<Inner_ball>;

  /// where the solid is thin, bends are no closer together than \p least_spacing. If it is not
  /// wanted, arcs are not pulled straight first.
  Arc_smoothing(const Wall& wall,
                const Inner_balls& balls,
                double least_spacing,
                bool pulls_straight = true)
      : wall_(wall)
      , balls_(balls)
      , least_spacing_(least_spacing)
      , pulls_straight_(pulls_straight) {}

  /// an arc by the balls along it, of which the first and the last stay where they are; the same
  /// for a cycle, which is open at its first place.
  /// The edge at an end that is an inlet stays as well: it is seen to be inside from there.
  Balls operator()(const Balls& arc, bool begins_at_inlet, bool ends_at_inlet) const {
    if(arc.size() < 2 + std::size_t(begins_at_inlet) + std::size_t(ends_at_inlet))
      return arc;
    const auto begin = arc.begin() + (begins_at_inlet ? 1 : 0),
               end = arc.end() - (ends_at_inlet ? 1 : 0);
    Balls drawn = (*this)(Balls(begin, end));
    drawn.insert(drawn.begin(), arc.begin(), begin);
    drawn.insert(drawn.end(), end, arc.end());
    return drawn;
  }

private:
  // Bends where the smooth arc leaves the solid stay where they were, and more beside them each
  // time.
  Balls operator()(const Balls& arc) const {
    constexpr int most_trials = 5;
    const Balls bends = with_bends(pulls_straight_ ? pulled_straight(arc) : arc);
    std::vector<char> is_free(bends.size(), 1);
    for(int k = 0; k < most_trials; ++k) {
      const Balls smooth = smoothed(bends, is_free);
      for(const Balls& drawn : {without_needless_bends(smooth), smooth})
        if(is_line_free(wall_, drawn))
          return drawn;
      keep_outside(smooth, std::size_t(1) << k, is_free);
    }
    return arc;
  }

  // So many on both sides.
  void keep_outside(const Balls& arc, std::size_t number, std::vector<char>& is_free) const {
    for(std::size_t i = 1; i < arc.size(); ++i)
      if(wall_.meets(arc[i - 1].centre, arc[i].centre))
        for(std::size_t k = i - (std::min)(i, number); k < (std::min)(i + number, arc.size()); ++k)
          is_free[k] = 0;
  }

  Balls smoothed(const Balls& bends, const std::vector<char>& is_free) const {
    Balls smooth = bends;
    make_smooth(smooth, is_free);
    std::vector<char> climbs = is_free;
    for(int k = 0; k < most_climbs && climb_together(smooth, climbs); ++k) {
      for(std::size_t i = 0; i < smooth.size(); ++i)
        if(is_free[i] == 0)
          smooth[i] = bends[i];
      make_smooth(smooth, is_free);
    }
    make_central(smooth, is_free);
    make_smooth(smooth, is_free);
    measure(smooth);
    return smooth;
  }

  static constexpr int rounds_of_smoothing = 12, most_climbs = 4;
  static constexpr double mobility = 0.25;  // of a bend, in its radius
  static constexpr double spacing = 0.5;    // of bends, in their radius
  static constexpr double precision = 0.95; // of radii

  // Leaves out places as long as the straight way to the next is no nearer to the surface: in
  // plates, where the middle is not a line, ways turn from side to side.
  Balls pulled_straight(const Balls& arc) const {
    Balls kept = {arc.front()};
    std::size_t last = 0;
    for(std::size_t i = 1; i + 1 < arc.size(); ++i)
      if(!is_as_central(arc, last, i + 1)) {
        kept.push_back(arc[i]);
        last = i;
      }
    kept.push_back(arc.back());
    return kept;
  }

  // Whether the straight way from a place to another is so far from the surface as that along the
  // arc. That to the one before is known to be free; nothing is to be between the two.
  bool is_as_central(const Balls& arc, std::size_t first, std::size_t last) const {
    constexpr double part = 0.9;
    constexpr int number = 8;
    const Vector &a = arc[first].centre, &b = arc[last].centre;
    if(wall_.meets(a, b) || wall_.meets(a, 0.5 * (arc[last - 1].centre + b)))
      return false;
    double length = 0.;
    for(std::size_t i = first; i < last; ++i)
      length += norm(arc[i + 1].centre - arc[i].centre);
    std::size_t i = first;
    double before = 0.;
    for(int k = 1; k < number; ++k) {
      const double t = double(k) / number;
      double step = norm(arc[i + 1].centre - arc[i].centre);
      while(before + step < t * length && i + 2 <= last) {
        before += step;
        ++i;
        step = norm(arc[i + 1].centre - arc[i].centre);
      }
      const double s = step > 0. ? (t * length - before) / step : 0.;
      const double least = part * ((1. - s) * arc[i].radius + s * arc[i + 1].radius);
      const Vector p = (1. - t) * a + t * b;
      if(wall_.is_within(p, least))
        return false;
    }
    return true;
  }

  Balls with_bends(const Balls& arc) const {
    constexpr double most = 16.;
    Balls all = {arc.front()};
    for(std::size_t i = 1; i < arc.size(); ++i) {
      const Inner_ball &a = arc[i - 1], &b = arc[i];
      const double length = norm(b.centre - a.centre), radius = (std::max)(a.radius, b.radius);
      const double apart = (std::max)(spacing * radius, least_spacing_);
      const int n = static_cast<int>((std::min)(most, apart > 0. ? std::ceil(length / apart) : 1.));
      for(int k = 1; k < n; ++k) {
        const double t = double(k) / n;
        const Vector p = (1. - t) * a.centre + t * b.centre;
        const double limit = (std::min)(a.radius + t * length, b.radius + (1. - t) * length);
        all.push_back({p, wall_.nearest(p, limit, precision).distance});
      }
      all.push_back(b);
    }
    return all;
  }

  static void make_smooth(Balls& arc, const std::vector<char>& is_free) {
    std::vector<Vector> points;
    for(const Inner_ball& ball : arc)
      points.push_back(ball.centre);
    // Forth and back, so that bows do not become flatter.
    for(int round = 0; round < rounds_of_smoothing; ++round)
      for(const double step : {0.5, -0.52}) {
        Vector before = points.front();
        for(std::size_t i = 1; i + 1 < arc.size(); ++i) {
          const Vector way = 0.5 * (before + points[i + 1]) - points[i];
          before = points[i];
          if(is_free[i] != 0)
            points[i] = near_centre(arc[i], points[i] + step * way);
        }
      }
    for(std::size_t i = 1; i + 1 < arc.size(); ++i) {
      arc[i].radius -= norm(points[i] - arc[i].centre); // at least so large
      arc[i].centre = points[i];
    }
  }

  static Vector near_centre(const Inner_ball& ball, const Vector& p) {
    const Vector off = p - ball.centre;
    const double distance = norm(off), most = mobility * ball.radius;
    return distance > most ? ball.centre + (most / distance) * off : p;
  }

  // Moves bends across the arc to where the solid is wider. Those beside each other go the same
  // way: in plates, any way leads to larger balls, by chance. Those that went so far that they may
  // go on climb the next time, if any do.
  bool climb_together(Balls& arc, std::vector<char>& climbs) const {
    constexpr double long_part = 0.5; // of the radius
    std::vector<Vector> shifts(arc.size(), Vector{0., 0., 0.});
    bool is_any = false;
    for(std::size_t i = 1; i + 1 < arc.size(); ++i) {
      const Vector along = arc[i + 1].centre - arc[i - 1].centre;
      if(const double length = norm(along); climbs[i] != 0 && length > 0. && !is_thin(arc[i])) {
        shifts[i] = shift_to_wider_place(arc[i], (1. / length) * along);
        is_any = true;
      }
      climbs[i] = 0;
    }
    make_even(shifts);
    for(std::size_t i = 1; i + 1 < arc.size(); ++i)
      if(const double length = norm(shifts[i]); length > 0.) {
        const double way = (std::min)(length, arc[i].radius); // so that it is inside
        climbs[i] = way > long_part * arc[i].radius;
        move_if_larger(arc[i], arc[i].centre + (way / length) * shifts[i], arc[i].radius + way);
      }
    return is_any;
  }

  // Whether no way that a ball climbs can be seen: in blades, of which there may be thousands side
  // by side.
  bool is_thin(const Inner_ball& ball) const {
    constexpr double part = 1. / 256.;
    return ball.radius < part * least_spacing_;
  }

  Vector shift_to_wider_place(const Inner_ball& start, const Vector& tangent) const {
    constexpr int most_steps = 6;
    constexpr double gain = 1.05;
    const Inner_ball ball = climb_across(wall_, start, tangent, most_steps);
    return ball.radius > gain * start.radius ? ball.centre - start.centre : Vector{0., 0., 0.};
  }

  static void make_even(std::vector<Vector>& shifts) {
    constexpr int number_of_rounds = 20;
    for(int round = 0; round < number_of_rounds; ++round) {
      Vector before = shifts.front();
      for(std::size_t i = 1; i + 1 < shifts.size(); ++i) {
        const Vector mean = 0.25 * (before + shifts[i + 1]) + 0.5 * shifts[i];
        before = shifts[i];
        shifts[i] = mean;
      }
    }
  }

  // Moves bends across the arc, towards the middles of larger balls.
  void make_central(Balls& arc, const std::vector<char>& is_free) const {
    const Balls before = arc;
    for(std::size_t i = 1; i + 1 < arc.size(); ++i) {
      const Vector along = before[i + 1].centre - before[i - 1].centre;
      const double length = norm(along);
      const Inner_ball larger = balls_.pushed({before[i].centre, 2. * before[i].radius});
      if(is_free[i] == 0 || !(length > 0.) || !(larger.radius > 0.))
        continue;
      const Vector tangent = (1. / length) * along, way = larger.centre - before[i].centre,
                   across = way - dot(way, tangent) * tangent;
      constexpr double most = 0.5;
      const double distance = norm(across), far_enough = most * before[i].radius;
      const Vector step = distance > far_enough ? (far_enough / distance) * across : across;
      move_if_larger(arc[i], before[i].centre + step, 2. * larger.radius);
    }
  }

  void move_if_larger(Inner_ball& ball, const Vector& p, double limit) const {
    const double radius = wall_.nearest(p, limit, precision).distance;
    if(radius > ball.radius)
      ball = {p, radius};
  }

  void measure(Balls& arc) const {
    for(std::size_t i = 1; i + 1 < arc.size(); ++i)
      arc[i].radius = wall_.nearest(arc[i].centre, 2. * arc[i].radius, precision).distance;
  }

  // Leaves out bends that are on the way, or so close to the next that they make no difference.
  static Balls without_needless_bends(const Balls& arc) {
    constexpr double flatness = 0.02, least_spacing = 0.3, most_spacing = 2.;
    Balls kept = {arc.front()};
    std::size_t last = 0;
    for(std::size_t i = 1; i + 1 < arc.size(); ++i) {
      const double length = norm(arc[i + 1].centre - arc[last].centre), radius = arc[i].radius;
      const bool is_straight =
          length < most_spacing * radius && deviation(arc, last, i + 1) < flatness * radius;
      if(!is_straight && norm(arc[i].centre - arc[last].centre) > least_spacing * radius) {
        kept.push_back(arc[i]);
        last = i;
      }
    }
    kept.push_back(arc.back());
    return kept;
  }

  // Of the places between two from the segment between these.
  static double deviation(const Balls& arc, std::size_t first, std::size_t last) {
    const Vector a = arc[first].centre, way = arc[last].centre - a;
    const double square = dot(way, way);
    double most = 0.;
    for(std::size_t i = first + 1; i < last; ++i) {
      const Vector off = arc[i].centre - a;
      const double t = square > 0. ? (std::max)(0., (std::min)(1., dot(off, way) / square)) : 0.;
      most = (std::max)(most, norm(off - t * way));
    }
    return most;
  }

  const Wall& wall_;
  const Inner_balls& balls_;
  double least_spacing_;
  bool pulls_straight_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_ARC_SMOOTHING_H
