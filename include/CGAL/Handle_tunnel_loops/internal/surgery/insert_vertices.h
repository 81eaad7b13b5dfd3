// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_INSERT_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_INSERT_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The points of a mesh, with predicates that are not exact: enough where any answer is a right
/// one.
template <typename SurfaceMesh> class Approximate_points
{
  using Original = typename SurfaceMesh::Point;

public:
  using key_type = typename SurfaceMesh::Vertex_index;
  using value_type = Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  explicit Approximate_points(SurfaceMesh& mesh)
      : points_(mesh.points()) {}

  friend value_type get(const Approximate_points& map, key_type v) {
    const Original& p = map.points_[v];
    return {p.x(), p.y(), p.z()};
  }
  friend void put(const Approximate_points& map, key_type v, const value_type& p) {
    put(map.points_, v, Original(p.x(), p.y(), p.z()));
  }

private:
  typename SurfaceMesh::template Property_map<key_type, Original> points_;
};

/// inserts vertices into some faces of a `Surface_mesh`, as dense as those around, and adds them to
/// \p vertices. The edges that are flipped for that have points on a plane and a circle as a rule,
/// for which exact predicates would take a third of the time.
template <typename SurfaceMesh>
void insert_vertices(SurfaceMesh& mesh,
                     const std::vector<typename SurfaceMesh::Face_index>& faces,
                     std::vector<typename SurfaceMesh::Vertex_index>& vertices) {
  std::vector<typename SurfaceMesh::Face_index> new_faces;
  Polygon_mesh_processing::refine(
      mesh, faces, std::back_inserter(new_faces), std::back_inserter(vertices),
      parameters::vertex_point_map(Approximate_points<SurfaceMesh>(mesh)));
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_INSERT_VERTICES_H
