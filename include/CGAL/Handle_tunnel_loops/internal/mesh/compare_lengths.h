// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_COMPARE_LENGTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_COMPARE_LENGTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/enum.h>

#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The point `p + ratio (q - p)`, exactly.
struct Edge_place
{
  Vector p, q;
  double ratio;
};

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

/// compares the lengths of two closed polylines through such points, exactly.
Comparison_result compare_lengths(const std::vector<Edge_place>& a,
                                  const std::vector<Edge_place>& b);

/// the ends of an interval that holds the length of a closed polyline through such points.
std::pair<double, double> length_interval(const std::vector<Edge_place>& places);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_COMPARE_LENGTHS_H
