// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Handle_measurer.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The power of two by which coordinates become at most about 1, so that their products are neither
/// infinite nor nothing. Nothing is rounded by it.
class Power_of_scale
{
public:
  explicit Power_of_scale(const std::vector<Vector>& places) {
    double largest = 0.;
    for(const Vector& p : places)
      for(const double x : p)
        largest = (std::max)(largest, std::abs(x));
    std::frexp(largest, &exponent_);
  }

  std::vector<Vector> into(std::vector<Vector> points) const {
    scale(points, -exponent_);
    return points;
  }

  void out_of(std::optional<Flat_ball>& ball) const {
    if(!ball)
      return;
    ball->radius = std::ldexp(ball->radius, exponent_);
    ball->error = std::ldexp(ball->error, exponent_);
    scale(ball->curve, exponent_);
  }

private:
  static void scale(std::vector<Vector>& points, int exponent) {
    for(Vector& p : points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
  }

  int exponent_ = 0;
};

Flat_measures measure_handles(Execution execution,
                              const Flat_mesh& mesh,
                              const std::vector<Vector>& places,
                              const std::vector<Polyline_pair>& pairs) {
  const Power_of_scale scale(places);
  std::vector<Polyline_pair> scaled;
  for(const Polyline_pair& pair : pairs)
    scaled.push_back({scale.into(pair[0]), scale.into(pair[1])});
  const std::vector<Vector> points = scale.into(places);
  Flat_measures measures = Handle_measurer(execution, mesh, points, scaled).measure();
  for(Flat_measures::Pair& pair : measures.pairs) {
    scale.out_of(pair.inside);
    scale.out_of(pair.outside);
  }
  return measures;
}

} // namespace CGAL::Handle_tunnel_loops::internal
