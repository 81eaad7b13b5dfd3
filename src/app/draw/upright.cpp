// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/upright.h"

#include "draw/samples.h"

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace htloops {
namespace {

constexpr std::size_t x_axis = 0, y_axis = 1, z_axis = 2;

// What a thing would stand on if a direction were upright.
struct Base
{
  double part = 0.;   // of the box of its shadow, what is between the points at the bottom
  double margin = -1; // how far the centre of the surface is within that; outside it falls over
  double height = 0.; // of that centre

  bool is_stable() const { return margin > 0.; }
};

// What is known of a surface that tells which way is up.
class Evidence
{
public:
  explicit Evidence(const htl_scene::Surface& surface)
      : points_(Ball_around(surface.points).moved(surface.points)) {
    const std::vector<Vector> samples = samples_of(points_, surface.triangles, 20000.);
    for(const Vector& p : samples)
      for(std::size_t i = 0; i < 3; ++i)
        centre_[i] += p[i] / double(samples.size());
    const auto look_along = [&](std::size_t i) { // both ways, and across
      const std::size_t axis = i % 3, what = i / 3;
      if(what == 2)
        symmetry[axis] = symmetry_of(samples, axis);
      else
        bases[axis][what] = base_of(axis, what == 0 ? 1. : -1.);
    };
    internal::for_each_index(internal::Execution::parallel(), 9, look_along, 1);
    is_machined = part_along_axes(surface.triangles) > 0.2;
    const CGAL::Bbox_3 box = box_of(points_);
    double largest = 0.;
    for(int axis = 0; axis < 3; ++axis)
      largest = (std::max)(largest, box.max(axis) - box.min(axis));
    for(int axis = 0; axis < 3; ++axis)
      extents[static_cast<std::size_t>(axis)] =
          largest > 0. ? (box.max(axis) - box.min(axis)) / largest : 0.;
  }

  std::array<std::array<Base, 2>, 3> bases; // for both directions of each axis
  std::array<double, 3> extents;            // of the box, parts of the largest
  std::array<double, 3> symmetry; // how much of it is its own image in the plane across an axis
  bool is_machined;               // much of it is flat, and straight with the axes

private:
  Base base_of(std::size_t axis, double sign) const;
  double symmetry_of(const std::vector<Vector>& samples, std::size_t axis) const;
  double part_along_axes(const std::vector<htl_scene::Triangle>& triangles) const;

  std::vector<Vector> points_;
  Vector centre_ = {0., 0., 0.};
};

double area_of_polygon(const std::vector<std::array<double, 2>>& corners) {
  double area = 0.;
  for(std::size_t i = 0; i < corners.size(); ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
    area += (p[0] * q[1] - p[1] * q[0]) / 2.;
  }
  return area;
}

// The convex hull of the points at the bottom is known well enough by the outermost in some
// directions.
Base Evidence::base_of(std::size_t axis, double sign) const {
  constexpr std::size_t around = 32;
  constexpr double least = std::numeric_limits<double>::lowest();
  constexpr double thickness = 0.06; // of the layer at the bottom, in the unit ball
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  double bottom = -least;
  for(const Vector& p : points_)
    bottom = (std::min)(bottom, sign * p[axis]);
  std::array<Vector, around> borders; // cosine, sine, how far out
  std::vector<std::array<double, 2>> corners(around, {0., 0.});
  for(std::size_t k = 0; k < around; ++k) {
    const double angle = 2. * pi * double(k) / around;
    borders[k] = {internal::cosine(angle), internal::sine(angle), least};
  }
  double low_u = -least, high_u = least, low_v = -least, high_v = least;
  for(const Vector& p : points_) {
    low_u = (std::min)(low_u, p[u]);
    high_u = (std::max)(high_u, p[u]);
    low_v = (std::min)(low_v, p[v]);
    high_v = (std::max)(high_v, p[v]);
    if(sign * p[axis] > bottom + thickness)
      continue;
    for(std::size_t k = 0; k < around; ++k)
      if(const double out = borders[k][0] * p[u] + borders[k][1] * p[v]; out > borders[k][2]) {
        borders[k][2] = out;
        corners[k] = {p[u], p[v]};
      }
  }
  Base base;
  const double shadow = (high_u - low_u) * (high_v - low_v);
  base.part = shadow > 0. ? area_of_polygon(corners) / shadow : 0.;
  base.margin = -least;
  for(const auto& [cosine, sine, out] : borders)
    base.margin = (std::min)(base.margin, out - cosine * centre_[u] - sine * centre_[v]);
  base.height = sign * centre_[axis] - bottom;
  return base;
}

double Evidence::symmetry_of(const std::vector<Vector>& samples, std::size_t axis) const {
  constexpr std::size_t side = 20;
  double reach = 1e-9;
  for(const Vector& p : points_)
    for(const double t : p)
      reach = (std::max)(reach, std::abs(t));
  std::vector<int> here(side * side * side), mirrored(here.size());
  const auto place = [&](double t) {
    return static_cast<std::size_t>(
        std::clamp((t / reach + 1.) / 2. * side, 0., double(side) - 1.));
  };
  const auto cell = [&](const Vector& p) {
    return (place(p[2]) * side + place(p[1])) * side + place(p[0]);
  };
  for(Vector p : samples) {
    ++here[cell(p)];
    p[axis] = -p[axis];
    ++mirrored[cell(p)];
  }
  double common = 0.;
  for(std::size_t c = 0; c < here.size(); ++c)
    common += (std::min)(here[c], mirrored[c]);
  return common / (std::max)(double(samples.size()), 1.);
}

double Evidence::part_along_axes(const std::vector<htl_scene::Triangle>& triangles) const {
  double along = 0., whole = 0.;
  for(const auto& [a, b, c] : triangles) {
    const Vector n = normal_of(points_[a], points_[b], points_[c]);
    const double area = norm(n);
    whole += area;
    if((std::max)({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])}) > 0.99999 * area)
      along += area;
  }
  return whole > 0. ? along / whole : 0.;
}

// How good an axis is as upright. A plane of symmetry contains what is upright: one across it, and
// no other, speaks against it.
double value_of(const Evidence& evidence, std::size_t axis, std::size_t sign) {
  const Base& base = evidence.bases[axis][sign];
  if(!base.is_stable())
    return 0.;
  const auto& symmetry = evidence.symmetry;
  const double other = (std::max)(symmetry[(axis + 1) % 3], symmetry[(axis + 2) % 3]);
  constexpr double flat = 0.25; // what is as flat as that lies, whatever its symmetry
  const bool is_flat = evidence.extents[axis] < flat;
  if(symmetry[axis] > 0.75 && other < 0.5 && !is_flat)
    return 0.;
  constexpr double least_part = 0.2; // a round back is not a base
  if(!evidence.is_machined && base.part < least_part)
    return 0.;
  const double least = *std::min_element(symmetry.begin(), symmetry.end());
  // Parts of machines lie as safely as they can. Statues are tall.
  const double safety =
      evidence.is_machined && base.height > 0. ? (std::min)(1., base.margin / base.height) : 1.;
  return base.part * (is_flat ? 1. : 1. - (symmetry[axis] - least)) * safety;
}

// How much better than z another axis has to be.
double demand_on_y(const Evidence& evidence, double value_of_z) {
  if(evidence.is_machined)
    return 2.5;
  constexpr double clear_base = 0.35;
  return value_of_z < clear_base ? 0.85 : 1.15;
}

// Whether a thing without a base is one that grew, or was modelled by hand: neither flat, nor the
// same in all directions.
bool is_figure(const Evidence& evidence) {
  const auto [least, most] =
      std::minmax_element(evidence.symmetry.begin(), evidence.symmetry.end());
  return !evidence.is_machined && *most > 0. && (*most < 0.6 || *most - *least > 0.15);
}

Vector along(std::size_t axis, double sign) {
  Vector direction = {0., 0., 0.};
  direction[axis] = sign;
  return direction;
}

} // namespace

Vector Axes::in_space(const Vector& v) const {
  Vector p;
  for(std::size_t i = 0; i < 3; ++i)
    p[i] = v[0] * right[i] + v[1] * front[i] + v[2] * up[i];
  return p;
}

Axes axes_of(const Vector& up) {
  const bool is_y_up = std::abs(up[1]) > std::abs(up[0]) && std::abs(up[1]) > std::abs(up[2]);
  const Vector usual = is_y_up ? Vector{0., 0., 1.} : Vector{0., -1., 0.};
  const Vector right = unit(cross(up, usual));
  return {right, cross(right, up), up};
}

Vector upright_direction(const htl_scene::Surface& surface) {
  const Evidence evidence(surface);
  const double of_y = value_of(evidence, y_axis, 0), of_z = value_of(evidence, z_axis, 0),
               of_x = value_of(evidence, x_axis, 0);
  if(of_y > demand_on_y(evidence, of_z) * of_z)
    return along(y_axis, 1.);
  if(of_x > 2.5 * of_z && of_x > 0.4)
    return along(x_axis, 1.);
  if(of_z > 0.)
    return along(z_axis, 1.);
  // Upside down only what cannot stand otherwise.
  constexpr double clear_base = 0.4;
  for(const std::size_t axis : {z_axis, y_axis})
    if(value_of(evidence, axis, 1) > clear_base && !evidence.bases[axis][0].is_stable())
      return along(axis, -1.);
  return is_figure(evidence) ? along(y_axis, 1.) : along(z_axis, 1.);
}

} // namespace htloops
