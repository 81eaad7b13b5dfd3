// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SURFACE_DISTANCES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SURFACE_DISTANCES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Distance_buckets.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the least of the distances of a vertex over the edge across a face, at the ends of which it is
/// known and between them linear.
inline double
distance_over_edge(const Vector& u, const Vector& v, const Vector& w, double at_v, double at_w) {
  const Vector along = w - v;
  const double size = norm(along), slope = (at_w - at_v) / size;
  if(!(std::abs(slope) < 1.))
    return (std::numeric_limits<double>::max)();
  const double foot = dot(u - v, along) / size, height = norm(cross(u - v, along)) / size,
               place = foot - slope * height / std::sqrt(1. - slope * slope);
  const double x = (std::min)((std::max)(place, 0.), size);
  return at_v + slope * x + std::sqrt((x - foot) * (x - foot) + height * height);
}

/// calls `reach(u, d)` for the neighbours that become nearer from a vertex, over its edges and
/// faces. Over these contours of distances do not know of the directions of the edges; they are as
/// exact as linear functions on the faces are. Unreached vertices are infinitely far.
/// \p is_open says of an edge whether it may be passed.
template <typename DistanceOf, typename IsOpen, typename Reach>
void relax_around(const Flat_mesh& mesh,
                  Index v,
                  const DistanceOf& distance,
                  const IsOpen& is_open,
                  const Reach& reach) {
  constexpr double worth_it = 1. - 1e-6;
  const Ring ring = mesh.ring(v);
  const double here = distance(v);
  for(Index p = 0; p < ring.size(); ++p) {
    const Index u = ring[p];
    if(distance(u) <= here || !is_open(v, u))
      continue;
    double d = here + mesh.edge_length(v, u);
    for(const Index w : {ring[ring.previous(p)], ring[ring.next(p)]})
      if(distance(w) <= here && !mesh.is_hub(w) && is_open(v, w) && is_open(u, w)) // or from there
        d = (std::min)(d, distance_over_edge(mesh.points[u], mesh.points[v], mesh.points[w], here,
                                             distance(w)));
    if(d < worth_it * distance(u))
      reach(u, d);
  }
}

/// distances on the surface from vertices, one of each component. Nothing goes through the hub of
/// a cap.
inline std::vector<float> surface_distances(const Flat_mesh& mesh,
                                            const std::vector<Index>& sources) {
  std::vector<float> distance(mesh.number_of_vertices(), std::numeric_limits<float>::infinity());
  std::vector<char> is_waiting(mesh.number_of_vertices(), 0);
  Distance_buckets buckets(mesh);
  const auto put = [&](Index v, float d, float now) {
    distance[v] = d;
    is_waiting[v] = 1;
    buckets.push((std::max)(d, now), v);
  };
  for(const Index v : sources)
    put(v, 0.f, 0.f);
  while(!buckets.empty())
    if(const Index v = buckets.pop(); std::exchange(is_waiting[v], char(0)) != 0 && !mesh.is_hub(v))
      relax_around(
          mesh, v, [&](Index u) -> double { return distance[u]; },
          [](Index, Index) { return true; },
          [&](Index u, double d) { put(u, static_cast<float>(d), distance[v]); });
  return distance;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SURFACE_DISTANCES_H
