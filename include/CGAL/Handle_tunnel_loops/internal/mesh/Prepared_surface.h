// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_PREPARED_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_PREPARED_SURFACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Loop_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A caller's surface as the package works on it: as arrays, with the vertices that they stand for.
/// The caller's mesh must outlive it.
template <typename TriangleMesh, typename VertexPointMap> struct Prepared_surface
{
  using Mesh = TriangleMesh;
  using Vertex_point_map = VertexPointMap;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// checks the mesh and takes it apart. Throws `Invalid_mesh_exception`.
  template <typename VertexIndexMap>
  Prepared_surface(Execution execution,
                   const TriangleMesh& mesh_of_caller,
                   VertexIndexMap vertex_index,
                   VertexPointMap point_map)
      : tm(mesh_of_caller)
      , point(point_map) {
    Flat_mesh_builder<TriangleMesh, VertexIndexMap, VertexPointMap> builder(execution, tm,
                                                                            vertex_index, point);
    mesh = builder.build();
    vertices = builder.take_vertices();
  }

  /// the index of a vertex of the caller, `no_index` of one that has no faces. Linear.
  Index index_of(vertex_descriptor v) const {
    const auto it = std::find(vertices.begin(), vertices.end(), v);
    return it == vertices.end() ? no_index : static_cast<Index>(it - vertices.begin());
  }

  /// turns loops on the arrays into loops on the caller's mesh.
  template <typename GeomTraits>
  Loop_converter<TriangleMesh, VertexPointMap, GeomTraits>
  converter(const GeomTraits& traits) const {
    return {tm, point, traits, vertices};
  }

  /// the coordinates of the vertices, rounded to doubles if they are none.
  std::vector<Simple_cartesian<double>::Point_3> coordinates(Execution execution) const {
    using FT = typename Kernel_traits<Point>::Kernel::FT;
    std::vector<Simple_cartesian<double>::Point_3> points(vertices.size());
    // Exact numbers may share what they are computed from, and know nothing of threads.
    for_each_index(std::is_floating_point<FT>::value ? execution : Execution(), points.size(),
                   [&](std::size_t i) {
                     const Vector p = internal::coordinates(point, vertices[i]);
                     points[i] = {p[0], p[1], p[2]};
                   });
    return points;
  }

  /// notes its size.
  template <typename Record> void describe(Record& statistics) const {
    statistics.number_of_vertices = vertices.size();
    statistics.number_of_faces = mesh.number_of_faces() - mesh.number_of_faces_of_caps();
    statistics.number_of_components = mesh.seeds.size();
    statistics.number_of_boundaries = mesh.number_of_hubs;
    statistics.genus = mesh.genus;
  }

  const TriangleMesh& tm;
  VertexPointMap point;
  Flat_mesh mesh;
  std::vector<vertex_descriptor> vertices; ///< by index of the arrays, but for the hubs
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_PREPARED_SURFACE_H
