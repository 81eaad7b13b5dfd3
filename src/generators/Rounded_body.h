// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ROUNDED_BODY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ROUNDED_BODY_H

#include "Field.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A ball with handles around its equator, like those of a pot, and with smaller balls as bumps,
/// all blended. The handles are the same however many there are, the ball is as large as they need.
class Rounded_body : public Field
{
public:
  struct Ball
  {
    Vector centre;
    double radius;
  };

  static constexpr double ring_radius = 0.5, tube_radius = 0.2;

  /// no loop that is not contractible is shorter.
  static constexpr double least_length = 1.;

  static double radius(std::size_t handles) {
    return (std::max)(1., 0.12 * static_cast<double>(handles));
  }

  /// the number of faces from which edges are short beside the handles.
  static std::size_t least_faces(std::size_t handles) {
    return static_cast<std::size_t>(25000. * radius(handles) * radius(handles));
  }

  /// \p bumps are those of a ball of radius one.
  Rounded_body(std::size_t handles, double first_angle, const std::vector<Ball>& bumps)
      : radius_(radius(handles)) {
    for(std::size_t i = 0; i < handles; ++i) {
      const double angle = first_angle + 2. * CGAL_PI * static_cast<double>(i) / handles;
      handles_.push_back(Vector(std::cos(angle), std::sin(angle), 0.));
    }
    balls_.push_back({Vector(0., 0., 0.), radius_});
    for(const Ball& bump : bumps)
      balls_.push_back({radius_ * bump.centre, radius_ * bump.radius});
  }

  Box box() const override {
    return Box{Vector(0., 0., 0.), Vector(0., 0., 0.)}.grown(1.5 * radius_ + 0.5);
  }

  double operator()(const Vector& p) const override {
    constexpr double blend_of_balls = 0.1, blend_of_handles = 0.05;
    double sum = 0.;
    for(const Ball& ball : balls_)
      sum += std::exp((ball.radius - length(p - ball.centre)) / (blend_of_balls * radius_));
    const double to_balls = -blend_of_balls * radius_ * std::log(sum);
    double least = to_balls;
    for(const Vector& outwards : handles_)
      least = (std::min)(least, distance_to_handle(p, outwards));
    // Relative to the least one: what is far must not vanish altogether.
    double blended = std::exp((least - to_balls) / blend_of_handles);
    for(const Vector& outwards : handles_)
      blended += std::exp((least - distance_to_handle(p, outwards)) / blend_of_handles);
    return least - blend_of_handles * std::log(blended);
  }

private:
  /// to the ring that stands upright on the equator.
  double distance_to_handle(const Vector& p, const Vector& outwards) const {
    const double out = p * outwards - radius_;
    const double aside = p.y() * outwards.x() - p.x() * outwards.y();
    return std::hypot(std::hypot(out, p.z()) - ring_radius, aside) - tube_radius;
  }

  double radius_;
  std::vector<Ball> balls_;
  std::vector<Vector> handles_; ///< the directions in which they are
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ROUNDED_BODY_H
