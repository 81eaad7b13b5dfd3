// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PUSHED_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PUSHED_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Cycle_trials.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Widest_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Loops of the surface, pushed off it to one side as far as balls fit.

Where points are far apart against what is thin, as in a long, thin tube, walks among them slip
through the surface everywhere, and none is known to be free. Loops are where there is a way. Which
class it is of, if any, is told by its linking numbers.
*/
class Pushed_loops
{
public:
  Pushed_loops(const Wall& wall, const Clearance& clearance, const Cycle_trials& trials)
      : wall_(wall)
      , clearance_(clearance)
      , trials_(trials) {}

  /// A walk, and the balls that fit along it.
  struct Free_walk
  {
    Linking_row row;
    Cycle_trial trial;
  };

  /// free walks beside a loop, on both sides, for balls of a radius, or a half of it, a quarter,
  /// and so on. As its partner crosses it once, the linking numbers with that differ by one: as
  /// long as they do not, walks have got into other classes; these are among the answers, too.
  std::vector<Free_walk> find(const std::vector<Vector>& loop, Index partner, double radius) const {
    constexpr int most_halvings = 12;
    std::vector<Free_walk> walks;
    std::array<std::optional<int>, 2> numbers;
    const auto are_known = [&] { return numbers[0] && numbers[1]; };
    for(int i = 0; i <= most_halvings; ++i, radius *= 0.5) {
      if(are_known() && std::abs(*numbers[0] - *numbers[1]) == 1)
        break;
      const bool is_again = are_known();
      for(const int side : {0, 1})
        if(!numbers[side] || is_again)
          if(auto found = free_walk(loop, side != 0, radius)) {
            numbers[side] = number_of(partner, found->row);
            walks.push_back(*std::move(found));
          }
    }
    return walks;
  }

private:
  static int number_of(Index loop, const Linking_row& row) {
    for(const auto& [other, number] : row)
      if(other == loop)
        return number;
    return 0;
  }

  std::optional<Free_walk>
  free_walk(const std::vector<Vector>& loop, bool is_left, double radius) const {
    const Widest_cycle balls = beside(loop, radius, is_left);
    if(balls.balls.empty())
      return std::nullopt;
    Cycle_trial trial = trials_.along(balls, radius, Cycle_trials::Places::SPREAD);
    if(!trial.is_wide)
      return std::nullopt;
    Linking_row row = trials_.row_of(trial.curve);
    return Free_walk{std::move(row), std::move(trial)};
  }

  // Balls at places about a radius apart, or as far as is free between, and then closer at the ends
  // of edges, where ways turn; but for those from where no room is found, and none if these are
  // many.
  Widest_cycle beside(const std::vector<Vector>& loop, double radius, bool is_left) const {
    constexpr double apart = 0.5;
    Balls_beside beside = {radius, {}, 0};
    double since = apart * radius;
    for(std::size_t i = 0; i < loop.size() && !beside.is_vain(); ++i) {
      const Vector &a = loop[i], &b = loop[i + 1 < loop.size() ? i + 1 : 0];
      const int n = 1 + static_cast<int>(norm(b - a) / radius);
      if(since += norm(b - a); n == 1 && since < apart * radius)
        continue;
      since = 0.;
      const auto ball = [&](int k) {
        return ball_at(point_between(a, b, (k + 0.5) / n), radius, is_left);
      };
      std::optional<Numbered_ball> last;
      for(const int k : graded_numbers(n)) {
        const Numbered_ball next = {k, ball(k)};
        if(last)
          add_between(ball, *last, next, beside);
        add(next.second, beside);
        last = next;
      }
    }
    Widest_cycle cycle = {0., {}, {}};
    if(!beside.is_vain())
      cycle.balls = std::move(beside.balls);
    return cycle;
  }

  struct Balls_beside
  {
    double radius;
    std::vector<Ball_network::Node> balls;
    std::size_t failures;

    bool is_vain() const {
      constexpr std::size_t many = 32;
      return failures > many + balls.size();
    }
  };

  static void add(const std::optional<Free_ball>& ball, Balls_beside& beside) {
    if(ball)
      beside.balls.push_back({ball->place, ball->radius});
    else
      ++beside.failures;
  }

  // Of the places on an edge of a loop, with their numbers.
  using Numbered_ball = std::pair<int, std::optional<Free_ball>>;

  // Of 0 .. n - 1, those at distances that double from either end.
  static std::vector<int> graded_numbers(int n) {
    std::vector<int> numbers;
    for(int k = 0; 2 * k < n; k = 2 * k + 1)
      numbers.push_back(k);
    for(std::size_t i = numbers.size(); i-- > 0;)
      if(const int k = n - 1 - numbers[i]; k > numbers.back())
        numbers.push_back(k);
    return numbers;
  }

  template <typename Function>
  void add_between(const Function& ball,
                   const Numbered_ball& a,
                   const Numbered_ball& b,
                   Balls_beside& beside) const {
    if(b.first - a.first < 2 || beside.is_vain() ||
       (a.second && b.second && !clearance_.narrow_between(*a.second, *b.second, beside.radius)))
      return;
    const int middle = (a.first + b.first) / 2;
    const Numbered_ball between = {middle, ball(middle)};
    add_between(ball, a, between, beside);
    add(between.second, beside);
    add_between(ball, between, b, beside);
  }

  // Beside a face, with more room around it, if that can be, so that walks may turn around corners.
  // At sides walls may meet at an acute angle: there a place just off one is beyond the other.
  std::optional<Free_ball> ball_at(const Vector& p, double radius, bool is_left) const {
    constexpr double nothing_is_farther = 4., part = 0.25, just_off = 0.01, more = 2.;
    constexpr int most_steps = 160; // out of corners that are as acute as faces are
    const Index f = wall_.nearest(p, nothing_is_farther).face;
    const std::array<Side, 2> sides = nearest_sides(p, f);
    const double away = part * (std::min)(radius, sides[1].distance);
    const Vector place = p + (std::max)(0., away - sides[0].distance) * sides[0].inwards +
                         (is_left ? just_off : -just_off) * away * unit(wall_.normal(f));
    const auto ball = clearance_.with_room(place, radius, most_steps);
    const auto larger = ball ? clearance_.with_room(ball->place, more * radius) : std::nullopt;
    return larger ? larger : ball;
  }

  /// Of a face, as seen from a place on it.
  struct Side
  {
    double distance;
    Vector inwards;
  };

  std::array<Side, 2> nearest_sides(const Vector& p, Index f) const {
    std::array<Side, 3> sides;
    for(int k = 0; k < 3; ++k) {
      const Vector &a = wall_.corner(f, k), &b = wall_.corner(f, (k + 1) % 3);
      const Vector inwards = unit(cross(wall_.normal(f), b - a));
      sides[k] = {(std::max)(0., dot(p - a, inwards)), inwards};
    }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.distance < b.distance; });
    return {sides[0], sides[1]};
  }

  const Wall& wall_;
  const Clearance& clearance_;
  const Cycle_trials& trials_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PUSHED_LOOPS_H
