// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_CENTREDNESS_H
#define BENCHMARK_CENTREDNESS_H

#include "Lines_in_space.h"
#include "Solid.h"

#include <CGAL/Kernel/global_functions.h>

#include <cmath>
#include <vector>

/// \file Centredness.h
/// How far a line is from the middle of a solid, by nothing but distances to the surface.

/// A ball of the plane across a line through one of its points, which grows while its centre walks
/// uphill in the distance to the surface. No step is longer than half the radius, so that the
/// centre stays in the free region.
class Ball_across
{
public:
  Ball_across(const Solid& solid, const Place_on_line& place)
      : solid_(solid)
      , start_(place.point)
      , centre_(place.point)
      , radius_(solid.distance(place.point)) {
    const auto& d = place.direction;
    const Kernel::Vector_3 aside =
        std::abs(d.x()) < 0.6 ? Kernel::Vector_3(1, 0, 0) : Kernel::Vector_3(0, 1, 0);
    u_ = CGAL::cross_product(d, aside);
    u_ = u_ / std::sqrt(u_.squared_length());
    v_ = CGAL::cross_product(d, u_);
  }

  double radius() const { return radius_; }

  /// grows to a local maximum; if it must hold the point of the line, to one of those that do.
  void grow(bool must_hold_start) {
    double step = 0.5 * radius_;
    for(int i = 0; i < most_steps && step > 0.01 * radius_; ++i)
      step = advances(step, golden_angle * i, must_hold_start)
                 ? (std::min)(2. * step, 0.5 * radius_)
                 : 0.5 * step;
  }

private:
  static constexpr int most_steps = 100, number_of_directions = 6;
  static constexpr double golden_angle = 2.399963229728653;

  // To the best of some points around. They are turned each time, as a ridge is narrow.
  bool advances(double step, double turn, bool must_hold_start) {
    const Point from = centre_;
    const double before = radius_;
    for(int i = 0; i < number_of_directions; ++i) {
      const double angle = turn + 2. * CGAL_PI * i / number_of_directions;
      const Point p = from + step * (std::cos(angle) * u_ + std::sin(angle) * v_);
      const double radius = solid_.distance(p);
      if(radius > radius_ &&
         !(must_hold_start && CGAL::squared_distance(p, start_) > radius * radius)) {
        centre_ = p;
        radius_ = radius;
      }
    }
    return radius_ > before;
  }

  const Solid& solid_;
  Point start_, centre_;
  double radius_;
  Kernel::Vector_3 u_, v_;
};

/// Radii at places of a line, each standing for an equal length of it, over those of the largest
/// balls found in the plane across; 0 where the line is outside.
struct Centredness
{
  std::vector<double> of_holding_ball; ///< that hold the place
  std::vector<double> of_section;      ///< anywhere, by a path uphill from there

  /// the share of the line that is better than what a ratio says.
  static double share_above(const std::vector<double>& ratios, double ratio) {
    const auto n = std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r > ratio; });
    return ratios.empty() ? 1. : double(n) / double(ratios.size());
  }
};

inline Centredness centredness(const Solid& solid, const Lines_in_space& lines) {
  constexpr std::size_t number_of_places = 200;
  Centredness result;
  for(const Place_on_line& place : places_on(lines, number_of_places)) {
    double ratio[] = {0., 0.};
    if(solid.contains(place.point)) {
      Ball_across ball(solid, place);
      const double at_line = ball.radius();
      for(const int i : {0, 1}) {
        ball.grow(i == 0);
        ratio[i] = ball.radius() > 0. ? at_line / ball.radius() : 0.;
      }
    }
    result.of_holding_ball.push_back(ratio[0]);
    result.of_section.push_back(ratio[1]);
  }
  return result;
}

#endif // BENCHMARK_CENTREDNESS_H
