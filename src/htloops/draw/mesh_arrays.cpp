// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/mesh_arrays.h"

namespace htloops {

std::vector<std::array<double, 3>> coordinates(const std::vector<Point>& points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(points.size());
  for(const Point& p : points)
    result.push_back(coordinates(p));
  return result;
}

std::vector<std::array<double, 3>> points_of(const Mesh& mesh) {
  std::vector<std::array<double, 3>> points;
  points.reserve(mesh.number_of_vertices());
  for(const Point& p : mesh.points())
    points.push_back(coordinates(p));
  return points;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(mesh.number_of_faces());
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    triangles.push_back(
        {mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return triangles;
}

} // namespace htloops
