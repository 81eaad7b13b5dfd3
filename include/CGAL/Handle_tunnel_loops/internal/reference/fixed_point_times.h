// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FIXED_POINT_TIMES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FIXED_POINT_TIMES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// a moment in steps, as `crossing_time()` gives those of the other solvers.
inline Time fixed_point_time(double moment) {
  const double step = std::ceil(moment);
  return static_cast<Time>(step) * ticks_per_step -
         static_cast<Time>((step - moment) * (ticks_per_step - 2));
}

/// The arrivals of a field from vertices and their neighbours in fixed point, `never` where it did
/// not come. Vertices that waited for a neighbour are later than it, so that the vertices from
/// which the field started remain the only minima.
inline std::vector<Time> fixed_point_times(const Flat_mesh& mesh,
                                           const Arrivals& arrivals,
                                           const std::vector<Index>& vertices) {
  std::vector<Index> order(arrivals.number_of_reached());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    if(arrivals.is_reached(v))
      order[arrivals.rank(v)] = v;
  std::vector<Time> times(mesh.number_of_vertices(), never);
  for(Index v : vertices)
    for(Index u : mesh.ring(v))
      times[u] = 1;
  for(Index v : vertices)
    times[v] = 0;
  for(Index v : order)
    if(times[v] == never) {
      Time earliest = never;
      for(Index u : mesh.ring(v))
        earliest = (std::min)(earliest, times[u]);
      times[v] = (std::max)(earliest + 1, fixed_point_time(arrivals.time(v)));
    }
  return times;
}

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FIXED_POINT_TIMES_H
