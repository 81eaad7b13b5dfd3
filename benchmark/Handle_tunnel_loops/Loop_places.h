// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_LOOP_PLACES_H
#define BENCHMARK_LOOP_PLACES_H

#include "Corpus_answer.h"

#include <cmath>
#include <tuple>

/// \file Loop_places.h
/// How far apart the loops of two answers lie in space.

namespace corpus {

using Space_point = Mesh::Point;
using Closed_polyline = std::vector<Space_point>;

/// a number of points, evenly spaced along a loop.
inline Closed_polyline sampled(const Closed_polyline& points, double length, std::size_t number) {
  Closed_polyline samples;
  double passed = 0.; // before the segment
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Space_point &a = points[i], &b = points[(i + 1) % points.size()];
    const double segment = std::sqrt(CGAL::squared_distance(a, b));
    while(samples.size() < number) {
      const double along = double(samples.size()) * length / double(number) - passed;
      if(along > segment)
        break;
      samples.push_back(segment > 0. ? a + (along / segment) * (b - a) : a);
    }
    passed += segment;
  }
  return samples;
}

inline double
squared_distance_to_segment(const Space_point& p, const Space_point& a, const Space_point& b) {
  const auto ab = b - a, ap = p - a;
  const double square = ab.squared_length();
  const double t = square > 0. ? std::clamp((ap * ab) / square, 0., 1.) : 0.;
  return (ap - t * ab).squared_length();
}

/// how far a point of one may be from the other.
inline double one_sided_distance(const Closed_polyline& from, const Closed_polyline& to) {
  double most = 0.;
  for(const Space_point& p : from) {
    double least = HUGE_VAL;
    for(std::size_t i = 0; i < to.size(); ++i)
      least = (std::min)(least, squared_distance_to_segment(p, to[i], to[(i + 1) % to.size()]));
    most = (std::max)(most, least);
  }
  return std::sqrt(most);
}

/// of all loops of an answer.
inline std::vector<Closed_polyline> sampled_loops(const Pairs& pairs, std::size_t number = 64) {
  std::vector<Closed_polyline> loops;
  for(const auto& pair : pairs)
    for(const auto* loop : {&pair.handle(), &pair.tunnel()})
      loops.push_back(sampled(loop->points(), loop->length(), number));
  return loops;
}

/// the Hausdorff distances of corresponding loops of two answers. Those that are closest
/// correspond, then those that are closest among the others, and so on.
inline std::vector<double> distances_of_corresponding(const Pairs& a, const Pairs& b) {
  const auto loops_a = sampled_loops(a), loops_b = sampled_loops(b);
  std::vector<std::tuple<double, std::size_t, std::size_t>> all;
  for(std::size_t i = 0; i < loops_a.size(); ++i)
    for(std::size_t j = 0; j < loops_b.size(); ++j)
      all.emplace_back((std::max)(one_sided_distance(loops_a[i], loops_b[j]),
                                  one_sided_distance(loops_b[j], loops_a[i])),
                       i, j);
  std::sort(all.begin(), all.end());
  std::vector<char> is_taken_a(loops_a.size(), 0), is_taken_b(loops_b.size(), 0);
  std::vector<double> distances;
  for(const auto& [distance, i, j] : all)
    if(is_taken_a[i] == 0 && is_taken_b[j] == 0) {
      is_taken_a[i] = is_taken_b[j] = 1;
      distances.push_back(distance);
    }
  return distances;
}

} // namespace corpus

#endif // BENCHMARK_LOOP_PLACES_H
