// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/view.h"

#include "draw/surfaces.h"

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace htloops {
namespace {

// A box in a cube from -1 to 1.
class Placement
{
public:
  explicit Placement(const std::vector<Vector>& points)
      : box_(box_of(points)) {
    for(int i = 0; i < 3; ++i) // an extent may be larger than the largest number
      half_ = (std::max)(half_, box_.max(i) / 2. - box_.min(i) / 2.);
  }

  bool is_point() const { return !(half_ > 0.); }

  Vector operator()(const Vector& p) const {
    Vector q;
    for(int i = 0; i < 3; ++i)
      q[i] = p[i] / half_ - (box_.min(i) / 2. + box_.max(i) / 2.) / half_;
    return q;
  }

private:
  CGAL::Bbox_3 box_;
  double half_ = 0.;
};

// Corners of a triangle in the cube.
std::array<Vector, 3>
placed_triangle(const htl_scene::Surface& surface, std::size_t t, const Placement& placed) {
  const auto& [i, j, k] = surface.triangles[t];
  return {placed(surface.points[i]), placed(surface.points[j]), placed(surface.points[k])};
}

double area_of(const std::array<Vector, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vector normal = cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, //
                              {c[0] - a[0], c[1] - a[1], c[2] - a[2]});
  return length_of_vector(normal[0], normal[1], normal[2]) / 2.;
}

// The n-th of points that are spread evenly over a triangle.
Vector point_in(const std::array<Vector, 3>& triangle, std::size_t n) {
  double whole; // steps by powers of the plastic number leave no gaps
  double u = std::modf(0.7548776662466927 * double(n), &whole),
         v = std::modf(0.5698402909980532 * double(n), &whole);
  if(u + v > 1.) {
    u = 1. - u;
    v = 1. - v;
  }
  const auto& [a, b, c] = triangle;
  Vector p;
  for(int x = 0; x < 3; ++x)
    p[x] = a[x] + u * (b[x] - a[x]) + v * (c[x] - a[x]);
  return p;
}

// Points of the surface that stand for equal parts of it, however large its triangles are.
std::vector<Vector> samples_of(const htl_scene::Surface& surface, const Placement& placed) {
  constexpr double number_of_samples = 60000.;
  double whole_area = 0.;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    whole_area += area_of(placed_triangle(surface, t, placed));
  std::vector<Vector> samples;
  double wanted = 0.;
  for(std::size_t t = 0; whole_area > 0. && t < surface.triangles.size(); ++t) {
    const std::array<Vector, 3> triangle = placed_triangle(surface, t, placed);
    wanted += number_of_samples * (area_of(triangle) / whole_area);
    while(double(samples.size()) < wanted)
      samples.push_back(point_in(triangle, samples.size()));
  }
  return samples;
}

// What is not behind samples of the surface.
class Depths
{
public:
  Depths(const std::vector<Vector>& samples, const Vector& from, const Vector& up)
      : from_(from)
      , right_(unit(cross(up, from)))
      , upwards_(cross(from, right_))
      , nearest_(cells * cells, -std::numeric_limits<double>::infinity()) {
    for(const Vector& sample : samples) {
      double& depth = nearest_[cell(sample)];
      depth = (std::max)(depth, dot(sample, from_));
    }
  }

  bool is_visible(const Vector& p) const {
    return dot(p, from_) > nearest_[cell(p)] - 4. * largest / cells;
  }

private:
  static constexpr int cells = 64;
  static constexpr double largest = 1.8; // more than half the diagonal of the cube

  std::size_t cell(const Vector& p) const {
    const auto along = [&](const Vector& axis) {
      return static_cast<std::size_t>((dot(p, axis) / largest + 1.) / 2. * cells);
    };
    return along(upwards_) * cells + along(right_);
  }

  Vector from_, right_, upwards_;
  std::vector<double> nearest_;
};

// How much is seen from a direction: of the surface, and above all of the chosen lines.
class Visibility
{
public:
  Visibility(const htl_scene::Surface& surface, const std::vector<std::vector<Vector>>& lines)
      : lines_(lines) {
    const Placement placed(surface.points);
    if(placed.is_point()) {
      lines_.clear();
      return;
    }
    samples_ = samples_of(surface, placed);
    for(std::vector<Vector>& line : lines_)
      for(Vector& p : line)
        p = placed(p);
  }

  double operator()(const Vector& from, const Vector& up) const {
    const Depths depths(samples_, from, up);
    // A short line counts as much as a long one, and all of them more than the surface.
    constexpr double weight_of_lines = 4.;
    double shares = 0.;
    for(const std::vector<Vector>& line : lines_)
      shares += visible_share(line, depths) / double(lines_.size());
    return visible_share(samples_, depths) + weight_of_lines * shares;
  }

private:
  static double visible_share(const std::vector<Vector>& points, const Depths& depths) {
    const auto visible = std::count_if(points.begin(), points.end(),
                                       [&](const Vector& p) { return depths.is_visible(p); });
    return double(visible) / double((std::max)(points.size(), std::size_t(1)));
  }

  std::vector<std::vector<Vector>> lines_;
  std::vector<Vector> samples_;
};

Vector best_direction(const htl_scene::Surface& surface,
                      const std::vector<std::vector<Vector>>& lines,
                      const Vector& up) {
  constexpr Vector oblique = {0.6, -1., 0.5};
  if(surface.triangles.empty())
    return oblique;
  const Visibility visibility(surface, lines);
  const Vector z = unit(up);
  const Vector x = unit(cross(std::abs(z[0]) < 0.9 ? Vector{1., 0., 0.} : Vector{0., 1., 0.}, z));
  const Vector y = cross(z, x);
  // Another direction has to show clearly more than the usual one.
  Vector best = oblique;
  double most = 1.05 * visibility(unit(oblique), z);
  constexpr int around = 16;
  std::vector<double> heights = {0.25, 0.7};
  if(!lines.empty())
    heights.insert(heights.end(), {-0.25, -0.7, 3.}); // there is something to be seen
  for(const double height : heights)
    for(int i = 0; i < around; ++i) {
      const double angle = 2. * pi * (i + 0.3) / around;
      Vector from;
      for(int k = 0; k < 3; ++k)
        from[k] = internal::cosine(angle) * x[k] + internal::sine(angle) * y[k] + height * z[k];
      if(const double seen = visibility(unit(from), z); seen > most) {
        most = seen;
        best = from;
      }
    }
  return best;
}

} // namespace

Whole_view whole_view(const View& given, const htl_scene::Surface& surface) {
  Whole_view view{{}, {0., 0., 1.}};
  if(!given.up.empty())
    view.up = {given.up[0], given.up[1], given.up[2]};
  view.from = given.from.empty() ? best_direction(surface, given.chosen, view.up)
                                 : Vector{given.from[0], given.from[1], given.from[2]};
  return view;
}

} // namespace htloops
