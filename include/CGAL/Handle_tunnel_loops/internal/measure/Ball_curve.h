// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_BALL_CURVE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_BALL_CURVE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

inline double closed_length(const std::vector<Vector>& points) {
  double sum = 0.;
  for(std::size_t i = 0; i < points.size(); ++i)
    sum += norm(points[i + 1 < points.size() ? i + 1 : 0] - points[i]);
  return sum;
}

/*!
A closed curve along which a ball of a given radius fits, made short: points are left out where the
straight way is free for the ball and passes the same curtains. It begins where the room is least,
to a part of the radius.
*/
class Ball_curve
{
public:
  Ball_curve(const Clearance& clearance,
             const Linked_segments& linked,
             double radius,
             std::vector<Free_ball> balls)
      : clearance_(clearance)
      , linked_(linked)
      , radius_(radius)
      , balls_(std::move(balls)) {}

  /// the curve, pulled tight as far as some rounds do it.
  std::vector<Vector> tightened() {
    constexpr int most_rounds = 4;
    constexpr double least_gain = 0.005;
    double length = closed_length(places());
    for(int round = 0; round < most_rounds; ++round) {
      leave_out();
      const double shorter = closed_length(places());
      if(round > 0 && shorter > (1. - least_gain) * length)
        break;
      length = shorter;
      if(round + 1 < most_rounds)
        divide();
    }
    begin_at_throat();
    return places();
  }

private:
  const Free_ball& ball(std::size_t i) const { return balls_[i == balls_.size() ? 0 : i]; }
  const Vector& at(std::size_t i) const { return ball(i).place; }

  std::vector<Vector> places() const {
    std::vector<Vector> places;
    for(const Free_ball& ball : balls_)
      places.push_back(ball.place);
    return places;
  }

  void leave_out() {
    names_.assign(1, 0);
    for(std::size_t i = 0; i < balls_.size(); ++i)
      names_.push_back(names_.back() + linked_.name(at(i), at(i + 1)));
    std::vector<Free_ball> left;
    for(std::size_t i = 0; i < balls_.size(); i = last_seen_from(i))
      left.push_back(balls_[i]);
    balls_ = std::move(left);
  }

  // By steps that double, and then are halved.
  std::size_t last_seen_from(std::size_t i) const {
    std::size_t last = i + 1, step = 1;
    for(; last + step <= balls_.size() && is_straight(i, last + step); step *= 2)
      last += step;
    for(; step > 0; step /= 2)
      if(last + step <= balls_.size() && is_straight(i, last + step))
        last += step;
    return last;
  }

  bool is_straight(std::size_t i, std::size_t j) const {
    return linked_.name(at(i), at(j)) == names_[j] - names_[i] &&
           !clearance_.narrow_between(ball(i), ball(j), radius_);
  }

  // New points on long pieces, at which they may be cut short.
  void divide() {
    std::vector<Free_ball> finer;
    for(std::size_t i = 0; i < balls_.size(); ++i) {
      finer.push_back(balls_[i]);
      const int n = static_cast<int>((std::min)(16., norm(at(i + 1) - at(i)) / radius_)) + 1;
      for(int k = 1; k < n; ++k)
        if(const Free_ball ball = clearance_.ball_at(
               (1. - double(k) / n) * at(i) + (double(k) / n) * at(i + 1), radius_);
           ball.radius >= radius_)
          finer.push_back(ball);
    }
    balls_ = std::move(finer);
  }

  /// Between two balls of the curve, or points between them.
  struct Piece
  {
    double least; // room, at least
    Free_ball a, b;
    std::size_t after; // which ball of the curve

    bool operator<(const Piece& other) const { return least > other.least; }
  };

  void begin_at_throat() {
    const double precision = 4. * clearance_.tolerance();
    std::priority_queue<Piece> pieces;
    const auto add = [&](const Free_ball& a, const Free_ball& b, std::size_t after) {
      pieces.push({Clearance::least_between(a, b), a, b, after});
    };
    Piece narrowest = {0., balls_[0], balls_[0], 0};
    for(std::size_t i = 0; i < balls_.size(); ++i) {
      if(balls_[i].radius < narrowest.a.radius)
        narrowest = {0., balls_[i], balls_[i], i};
      add(balls_[i], ball(i + 1), i);
    }
    while(pieces.top().least < (1. - precision) * narrowest.a.radius) {
      const Piece whole = pieces.top();
      pieces.pop();
      const Free_ball middle = clearance_.ball_at(0.5 * (whole.a.place + whole.b.place), radius_);
      if(middle.radius < narrowest.a.radius)
        narrowest = {0., middle, middle, whole.after};
      add(whole.a, middle, whole.after);
      add(middle, whole.b, whole.after);
    }
    std::rotate(balls_.begin(), balls_.begin() + static_cast<std::ptrdiff_t>(narrowest.after) + 1,
                balls_.end());
    if(narrowest.a.place != balls_.back().place)
      balls_.insert(balls_.begin(), narrowest.a);
    else
      std::rotate(balls_.begin(), balls_.end() - 1, balls_.end());
  }

  const Clearance& clearance_;
  const Linked_segments& linked_;
  double radius_;
  std::vector<Free_ball> balls_;
  std::vector<std::uint64_t> names_; // of the way to each point
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_BALL_CURVE_H
