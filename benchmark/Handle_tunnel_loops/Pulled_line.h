// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_PULLED_LINE_H
#define BENCHMARK_PULLED_LINE_H

#include "Loop_cones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

/// \file Pulled_line.h
/// Closed lines that keep away from a surface.

namespace voxel_measures {

/// How close a closed line comes to a surface, at most by a part too low: distances change no
/// faster than places do.
class Line_clearance
{
public:
  Line_clearance(const Triangle_tree& surface, const Line& line)
      : surface_(surface)
      , least_(std::numeric_limits<double>::infinity()) {
    std::vector<double> distances;
    for(const Point& p : line) {
      distances.push_back(surface.nearest(p).distance);
      least_ = (std::min)(least_, distances.back());
    }
    for(std::size_t i = 0, j = line.size() - 1; i < line.size(); j = i++)
      descend(line[i], distances[i], line[j], distances[j], 0);
  }

  double value() const { return least_ * (1. - slack); }

private:
  static constexpr double slack = 1e-3;

  void descend(const Point& a, double at_a, const Point& b, double at_b, int depth) {
    const double bound = (at_a + at_b - distance(a, b)) / 2.;
    if(bound >= least_ * (1. - slack))
      return;
    if(depth == 30) {
      least_ = (std::max)(bound, 0.);
      return;
    }
    const Point middle = CGAL::midpoint(a, b);
    const double at_middle = surface_.nearest(middle).distance;
    least_ = (std::min)(least_, at_middle);
    descend(a, at_a, middle, at_middle, depth + 1);
    descend(middle, at_middle, b, at_b, depth + 1);
  }

  const Triangle_tree& surface_;
  double least_;
};

inline double clearance(const Triangle_tree& surface, const Line& line) {
  return Line_clearance(surface, line).value();
}

/// A closed line that is pulled away from a surface where it comes close. Nothing is proved by
/// pulling; what is proved is how far away the line is at the end.
class Pulled_line
{
public:
  Pulled_line(const Triangle_tree& surface, const Line& line, double wanted)
      : surface_(surface) {
    for(const Point& p : line)
      places_.push_back(surface_.nearest(p)), points_.push_back(p);
    double pull = 0.25;
    for(int round = 0; round < rounds; ++round, pull *= 0.8) {
      space(wanted);
      for(std::size_t i = 0; i < points_.size(); ++i)
        move(i, wanted, pull);
    }
  }

  const Line& line() const { return points_; }

private:
  static constexpr int rounds = 24;

  std::size_t after(std::size_t i) const { return (i + 1) % points_.size(); }
  std::size_t before(std::size_t i) const { return (i + points_.size() - 1) % points_.size(); }

  // Points neither far from each other, for the room that they have, nor close.
  void space(double wanted) {
    Line points;
    std::vector<Triangle_tree::Nearest> places;
    for(std::size_t i = 0; i < points_.size(); ++i) {
      const double room = (std::min)(places_[i].distance, places_[after(i)].distance);
      if(points.size() > 2 && distance(points.back(), points_[i]) < 0.1 * places_[i].distance &&
         distance(points.back(), points_[after(i)]) < 0.4 * room)
        continue;
      points.push_back(points_[i]);
      places.push_back(places_[i]);
      const double gap = distance(points_[i], points_[after(i)]);
      const double parts =
          std::clamp(std::ceil(gap / (0.3 * (std::max)(room, 0.3 * wanted))), 1., 1000.);
      for(double k = 1.; k < parts; ++k) {
        points.push_back(points_[i] + k / parts * (points_[after(i)] - points_[i]));
        places.push_back(surface_.nearest(points.back()));
      }
    }
    points_ = std::move(points);
    places_ = std::move(places);
  }

  // To the middle of its neighbours, as far as that leaves it room, and away from the surface.
  void move(std::size_t i, double wanted, double pull) {
    if(places_[i].distance > 1.5 * wanted)
      return;
    const Point middle = CGAL::midpoint(points_[before(i)], points_[after(i)]);
    const Point smooth = points_[i] + pull * (middle - points_[i]);
    const auto there = surface_.nearest(smooth);
    if(there.distance >= (std::min)(places_[i].distance, 1.1 * wanted))
      set(i, smooth, there);
    const Triangle_tree::Nearest& nearest = places_[i];
    if(nearest.distance >= 1.02 * wanted || nearest.distance == 0.)
      return;
    const double step = (std::min)(pull * nearest.distance, 1.02 * wanted - nearest.distance);
    const Point away = points_[i] + step / nearest.distance * (points_[i] - nearest.place);
    set(i, away, surface_.nearest(away));
  }

  void set(std::size_t i, const Point& p, const Triangle_tree::Nearest& nearest) {
    points_[i] = p;
    places_[i] = nearest;
  }

  const Triangle_tree& surface_;
  Line points_;
  std::vector<Triangle_tree::Nearest> places_; ///< of the surface, by point
};

} // namespace voxel_measures

#endif // BENCHMARK_PULLED_LINE_H
