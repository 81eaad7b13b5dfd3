// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "crosses_itself.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

bool crosses_itself(const Soup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> vertices;
  for(const auto& [x, y, z] : soup.points)
    vertices.push_back(mesh.add_vertex({x, y, z}));
  for(const auto& [a, b, c] : soup.triangles)
    mesh.add_face(vertices[a], vertices[b], vertices[c]);
  return CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
