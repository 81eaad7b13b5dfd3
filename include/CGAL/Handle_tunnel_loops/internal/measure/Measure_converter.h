// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_CONVERTER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_CONVERTER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Handle_measures.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/number_utils.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the loops of the caller's pairs as polylines.
template <typename PairRange> std::vector<Polyline_pair> polylines_of(const PairRange& pairs) {
  const auto polyline = [](const auto& loop) {
    std::vector<Vector> points;
    for(const auto& p : loop.points())
      points.push_back({to_double(p.x()), to_double(p.y()), to_double(p.z())});
    return points;
  };
  std::vector<Polyline_pair> polylines;
  for(const auto& pair : pairs)
    polylines.push_back({polyline(pair.handle()), polyline(pair.tunnel())});
  return polylines;
}

template <typename Point>
std::optional<Threaded_ball<Point>> ball_of_caller(const std::optional<Flat_ball>& ball) {
  if(!ball)
    return std::nullopt;
  Threaded_ball<Point> converted;
  converted.diameter = 2. * ball->radius;
  converted.error = 2. * ball->error;
  for(const Vector& p : ball->curve)
    converted.curve.emplace_back(p[0], p[1], p[2]);
  converted.throat = converted.curve.front();
  return converted;
}

template <typename Point>
Handle_measures<Point> measures_of_caller(const Flat_measures::Pair& pair, const std::string& why) {
  Handle_measures<Point> measures;
  measures.thickness = ball_of_caller<Point>(pair.inside);
  measures.clear_width = ball_of_caller<Point>(pair.outside);
  if(!measures.thickness || !measures.clear_width)
    measures.why = why;
  return measures;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_CONVERTER_H
