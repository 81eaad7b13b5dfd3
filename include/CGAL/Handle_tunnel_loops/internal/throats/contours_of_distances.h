// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_CONTOURS_OF_DISTANCES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_CONTOURS_OF_DISTANCES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/furthest_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/measure_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Swept_function.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/surface_distances.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// how far vertices are from the middle of their component, in space.
inline std::vector<float> distances_from_middles(const Flat_mesh& mesh) {
  std::vector<Vector> sums(mesh.seeds.size(), Vector{0., 0., 0.});
  std::vector<double> weights(mesh.seeds.size(), 0.);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    if(mesh.is_hub(v))
      continue;
    const double weight = area_around(mesh, v);
    sums[mesh.component[v]] = sums[mesh.component[v]] + weight * mesh.points[v];
    weights[mesh.component[v]] += weight;
  }
  std::vector<float> distances(mesh.number_of_vertices(), 0.f);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Index c = mesh.component[v];
    if(weights[c] > 0. && !mesh.is_hub(v))
      distances[v] = static_cast<float>(norm(mesh.points[v] - (1. / weights[c]) * sums[c]));
  }
  return distances;
}

/// the contours that are shorter by \p part than those beside them, of distances on the surface
/// from its ends, and of the sum of these. An end is the furthest vertex from those before it.
inline std::vector<Crossing_loop>
short_contours_of_distances(Execution execution, const Flat_mesh& mesh, double part) {
  constexpr std::size_t number_of_ends = 8; // of each component
  std::vector<float> nearest = distances_from_middles(mesh), sum(mesh.number_of_vertices(), 0.f);
  std::vector<Crossing_loop> contours;
  const auto look_at = [&](std::vector<float> distance) {
    for(Crossing_loop& contour :
        Swept_function(execution, mesh, std::move(distance)).shortest_contours(part))
      contours.push_back(std::move(contour));
  };
  for(std::size_t i = 0; i < number_of_ends; ++i) {
    std::vector<Index> ends = furthest_vertices(mesh, nearest);
    for(Index& v : ends)
      v = mesh.is_hub(v) ? mesh.ring(v)[0] : v;
    std::vector<float> distance = surface_distances(mesh, ends);
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      nearest[v] = i == 0 ? distance[v] : (std::min)(nearest[v], distance[v]);
      sum[v] += distance[v];
    }
    look_at(std::move(distance));
  }
  look_at(std::move(sum));
  return contours;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_CONTOURS_OF_DISTANCES_H
