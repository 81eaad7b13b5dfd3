// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_EDGE_PLACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_EDGE_PLACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The point `p + ratio (q - p)`, exactly.
struct Edge_place
{
  Vector p, q;
  double ratio;
};

inline std::vector<Edge_place> edge_places(const Flat_mesh& mesh, const Crossing_loop& loop) {
  std::vector<Edge_place> places;
  places.reserve(loop.size());
  for(const Crossing& c : loop)
    places.push_back({mesh.points[c.left], mesh.points[c.right], ratio_on_surface(mesh, c)});
  return places;
}

template <typename TriangleMesh, typename Point, typename NamedParameters>
std::vector<Edge_place> edge_places(const TriangleMesh& tm,
                                    const Loop_on_surface<TriangleMesh, Point>& loop,
                                    const NamedParameters& np) {
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  std::vector<Edge_place> places;
  places.reserve(loop.size());
  for(const auto& step : loop.steps())
    places.push_back({coordinates(point, source(step.halfedge, tm)),
                      coordinates(point, target(step.halfedge, tm)), step.ratio});
  return places;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_EDGE_PLACE_H
