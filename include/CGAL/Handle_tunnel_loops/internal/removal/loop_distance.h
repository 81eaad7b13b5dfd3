// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOP_DISTANCE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOP_DISTANCE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// how far a loop, given by its points, is from the places of another one: the mean distance,
/// against a quarter of its length.
inline double loop_distance(const Surgery_mesh& mesh,
                            const std::vector<Surgery_mesh::Point>& points,
                            double length,
                            const Loop_choice& other) {
  // A few points tell as much as all.
  constexpr std::size_t number_of_points = 32;
  const std::size_t step = 1 + points.size() / number_of_points;
  const std::size_t step_of_other = 1 + other.places.size() / (4 * number_of_points);
  double sum = 0.;
  std::size_t number = 0;
  for(std::size_t i = 0; i < points.size(); i += step, ++number) {
    double least = (std::numeric_limits<double>::infinity)();
    for(std::size_t j = 0; j < other.places.size(); j += step_of_other)
      least = (std::min)(least, CGAL::squared_distance(points[i], point_at(mesh, other.places[j])));
    sum += std::sqrt(least);
  }
  return sum / (static_cast<double>(number) * length / 4.);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOP_DISTANCE_H
