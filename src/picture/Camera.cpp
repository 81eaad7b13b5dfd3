// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Camera.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace htl_picture {
namespace {

constexpr float eye_distance = 5.f; // in units of the frame: far enough for parallels to look so

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// the vector of length one, or `fallback` for none.
Point normalized(const Point& a, const Point& fallback) {
  const double length = std::sqrt(dot(a, a));
  return length > 0. ? Point{a[0] / length, a[1] / length, a[2] / length} : fallback;
}

/// An interval that grows to hold numbers.
struct Extent
{
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double x) {
    low = (std::min)(low, x);
    high = (std::max)(high, x);
  }
  double middle() const { return low <= high ? low + (high - low) / 2. : 0.; }
  double size() const { return (std::max)(high - low, 1e-6); }
};

} // namespace

Camera::Camera(const std::vector<const std::vector<Point>*>& seen,
               const Point& view,
               const Point& up,
               int width,
               int height,
               double part) {
  const Point z = normalized(view, {0., 0., 1.});
  // Looking along the upright direction, any other will do.
  const Point x = normalized(cross(up, z), normalized(cross({0., 1., 0.}, z), {1., 0., 0.}));
  axes_ = {x, cross(z, x), z};
  choose_unit(seen);
  fill_picture(seen, width, height, part);
}

Vector_3 Camera::in_frame(const Point& p) const {
  const Point q = {(p[0] - centre_[0]) / unit_, (p[1] - centre_[1]) / unit_,
                   (p[2] - centre_[2]) / unit_};
  return {float(dot(q, axes_[0])), float(dot(q, axes_[1])), float(dot(q, axes_[2]))};
}

Projected_point Camera::project(Vector_3 p) const {
  const float inverse_depth = 1.f / (eye_distance - p.z);
  return {shift_x_ + scale_ * p.x * inverse_depth, shift_y_ - scale_ * p.y * inverse_depth,
          inverse_depth};
}

Vector_3 Camera::unproject(Projected_point p) const {
  const float depth = 1.f / p.inverse_depth;
  return {(p.x - shift_x_) / scale_ * depth, (shift_y_ - p.y) / scale_ * depth,
          eye_distance - depth};
}

void Camera::choose_unit(const std::vector<const std::vector<Point>*>& seen) {
  std::array<Extent, 3> box;
  for(const auto* points : seen)
    for(const Point& p : *points)
      for(int i = 0; i < 3; ++i) {
        if(!std::isfinite(p[i]))
          throw std::runtime_error("no picture: a coordinate is not finite");
        box[i].add(p[i]);
      }
  for(int i = 0; i < 3; ++i)
    centre_[i] = box[i].middle();

  double largest = 0.;
  for(const auto* points : seen)
    for(const Point& p : *points)
      largest =
          (std::max)(largest, std::hypot(p[0] - centre_[0], p[1] - centre_[1], p[2] - centre_[2]));
  if(largest > 0.)
    unit_ = largest;
}

void Camera::fill_picture(const std::vector<const std::vector<Point>*>& seen,
                          int width,
                          int height,
                          double part) {
  Extent x, y;
  for(const auto* points : seen)
    for(const Point& p : *points) {
      const Projected_point q = project(in_frame(p)); // with scale 1 and no shift yet
      x.add(q.x);
      y.add(q.y);
    }
  scale_ = static_cast<float>(part * (std::min)(width / x.size(), height / y.size()));
  shift_x_ = static_cast<float>(width / 2. - scale_ * x.middle());
  shift_y_ = static_cast<float>(height / 2. - scale_ * y.middle());
}

} // namespace htl_picture
