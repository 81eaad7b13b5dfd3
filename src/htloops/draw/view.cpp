// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/view.h"

#include "draw/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace htloops {
namespace {

// Middles of triangles in a cube from -1 to 1, and how large these are.
struct Sample
{
  Vector place;
  double area;
};

std::vector<Sample> samples_of(const Drawn_surface& surface) {
  Vector low = surface.points.front(), high = low;
  for(const Vector& p : surface.points)
    for(int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  double half = 0.; // an extent may be larger than the largest number
  for(int i = 0; i < 3; ++i)
    half = (std::max)(half, high[i] / 2. - low[i] / 2.);
  if(!(half > 0.))
    return {};
  const auto placed = [&](const Vector& p) {
    Vector q;
    for(int i = 0; i < 3; ++i)
      q[i] = p[i] / half - (low[i] / 2. + high[i] / 2.) / half;
    return q;
  };
  constexpr std::size_t most_samples = 60000;
  const std::size_t step = surface.triangles.size() / most_samples + 1;
  std::vector<Sample> samples;
  for(std::size_t t = 0; t < surface.triangles.size(); t += step) {
    const auto& [i, j, k] = surface.triangles[t];
    const Vector a = placed(surface.points[i]), b = placed(surface.points[j]),
                 c = placed(surface.points[k]);
    Vector middle, u, v;
    for(int x = 0; x < 3; ++x) {
      middle[x] = (a[x] + b[x] + c[x]) / 3.;
      u[x] = b[x] - a[x];
      v[x] = c[x] - a[x];
    }
    const Vector normal = cross(u, v);
    samples.push_back({middle, std::hypot(normal[0], normal[1], normal[2])});
  }
  return samples;
}

// How much of the samples is not behind others.
double visible_area(const std::vector<Sample>& samples, const Vector& from, const Vector& up) {
  constexpr int cells = 64;
  constexpr double largest = 1.8; // more than half the diagonal of the cube
  const Vector right = unit(cross(up, from)), upwards = cross(from, right);
  const auto cell = [&](const Vector& p) {
    const auto along = [&](const Vector& axis) {
      return static_cast<std::size_t>((dot(p, axis) / largest + 1.) / 2. * cells);
    };
    return along(upwards) * cells + along(right);
  };
  std::vector<double> nearest(cells * cells, -std::numeric_limits<double>::infinity());
  for(const Sample& sample : samples) {
    double& depth = nearest[cell(sample.place)];
    depth = (std::max)(depth, dot(sample.place, from));
  }
  double area = 0.;
  for(const Sample& sample : samples)
    if(dot(sample.place, from) > nearest[cell(sample.place)] - 4. * largest / cells)
      area += sample.area;
  return area;
}

Vector best_direction(const Drawn_surface& surface, const Vector& up) {
  constexpr Vector oblique = {0.6, -1., 0.5};
  if(surface.triangles.empty())
    return oblique;
  const std::vector<Sample> samples = samples_of(surface);
  const Vector z = unit(up);
  const Vector x = unit(cross(std::abs(z[0]) < 0.9 ? Vector{1., 0., 0.} : Vector{0., 1., 0.}, z));
  const Vector y = cross(z, x);
  // Another direction has to show clearly more than the usual one.
  Vector best = oblique;
  double most = 1.05 * visible_area(samples, unit(oblique), z);
  constexpr int around = 16;
  for(const double height : {0.25, 0.7})
    for(int i = 0; i < around; ++i) {
      const double angle = 2. * pi * (i + 0.3) / around;
      Vector from;
      for(int k = 0; k < 3; ++k)
        from[k] = std::cos(angle) * x[k] + std::sin(angle) * y[k] + height * z[k];
      if(const double area = visible_area(samples, unit(from), z); area > most) {
        most = area;
        best = from;
      }
    }
  return best;
}

} // namespace

Whole_view whole_view(const View& given, const Drawn_surface& surface) {
  Whole_view view{{}, {0., 0., 1.}};
  if(!given.up.empty())
    view.up = {given.up[0], given.up[1], given.up[2]};
  view.from = given.from.empty() ? best_direction(surface, view.up)
                                 : Vector{given.from[0], given.from[1], given.from[2]};
  return view;
}

} // namespace htloops
