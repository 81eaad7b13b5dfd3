// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace htloops {
namespace {

// The n-th of points that are spread evenly over a triangle.
Vector point_in(const Vector& a, const Vector& b, const Vector& c, std::size_t n) {
  double whole; // steps by powers of the plastic number leave no gaps
  double u = std::modf(0.7548776662466927 * double(n), &whole),
         v = std::modf(0.5698402909980532 * double(n), &whole);
  if(u + v > 1.) {
    u = 1. - u;
    v = 1. - v;
  }
  Vector p;
  for(int x = 0; x < 3; ++x)
    p[x] = a[x] + u * (b[x] - a[x]) + v * (c[x] - a[x]);
  return p;
}

} // namespace

Ball_around::Ball_around(const std::vector<Vector>& points)
    : box_(box_of(points)) {
  for(int i = 0; i < 3; ++i) // an extent may be larger than the largest number
    half_ = (std::max)(half_, box_.max(i) / 2. - box_.min(i) / 2.);
  double radius = 0.;
  for(const Vector& p : points)
    radius = (std::max)(radius, norm(in_cube(p)));
  if(radius > 0.)
    radius_ = radius;
}

Vector Ball_around::in_cube(const Vector& p) const {
  Vector q = {0., 0., 0.};
  for(int i = 0; i < 3 && half_ > 0.; ++i)
    q[i] = p[i] / half_ - (box_.min(i) / 2. + box_.max(i) / 2.) / half_;
  return q;
}

Vector Ball_around::operator()(const Vector& p) const {
  const Vector q = in_cube(p);
  return {q[0] / radius_, q[1] / radius_, q[2] / radius_};
}

std::vector<Vector> Ball_around::moved(const std::vector<Vector>& points) const {
  std::vector<Vector> moved;
  moved.reserve(points.size());
  for(const Vector& p : points)
    moved.push_back((*this)(p));
  return moved;
}

std::vector<Vector> samples_of(const std::vector<Vector>& points,
                               const std::vector<htl_scene::Triangle>& triangles,
                               double count) {
  std::vector<double> areas;
  areas.reserve(triangles.size());
  double whole = 0.;
  for(const auto& [a, b, c] : triangles) {
    areas.push_back(norm(normal_of(points[a], points[b], points[c])));
    whole += areas.back();
  }
  std::vector<Vector> samples;
  double wanted = 0.;
  for(std::size_t t = 0; whole > 0. && t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    wanted += count * (areas[t] / whole);
    while(double(samples.size()) < wanted)
      samples.push_back(point_in(points[a], points[b], points[c], samples.size()));
  }
  return samples;
}

} // namespace htloops
