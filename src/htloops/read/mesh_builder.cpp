// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/mesh_builder.h"

#include <vector>

namespace htloops {
namespace {

// Links the halfedges without a face; one begins at each vertex of the boundary, and one ends
// there.
void close_borders(Mesh& mesh, const std::vector<Mesh::Halfedge_index>& borders) {
  for(const Mesh::Halfedge_index h : borders)
    mesh.set_halfedge(mesh.target(h), h);
  for(const Mesh::Halfedge_index h : borders)
    mesh.set_next(mesh.halfedge(mesh.source(h)), h);
}

} // namespace

Mesh build_mesh(const Soup& soup, const Diagnosis& diagnosis) {
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;
  using Halfedge = Mesh::Halfedge_index;

  const auto number_of_faces = static_cast<std::uint32_t>(soup.faces.size());
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()),
               static_cast<Mesh::size_type>(diagnosis.edges.size()), number_of_faces);
  for(const Point& point : soup.points)
    mesh.add_vertex(point);

  std::vector<Halfedge> halfedges(3 * soup.faces.size());
  std::vector<Halfedge> borders;
  for(const auto& [h, g] : diagnosis.edges) {
    halfedges[h] = mesh.add_edge();
    const Halfedge opposite = mesh.opposite(halfedges[h]);
    if(g != Diagnosis::no_halfedge)
      halfedges[g] = opposite;
    else {
      mesh.set_target(opposite, Vertex(soup.source(h)));
      borders.push_back(opposite);
    }
  }
  for(std::uint32_t f = 0; f < number_of_faces; ++f) {
    const Face face = mesh.add_face();
    const std::uint32_t first = 3 * f;
    mesh.set_halfedge(face, halfedges[first]);
    for(std::uint32_t h = first; h < first + 3; ++h) {
      const Vertex target(soup.source(next_in_triangle(h)));
      mesh.set_target(halfedges[h], target);
      mesh.set_halfedge(target, halfedges[h]);
      mesh.set_face(halfedges[h], face);
      mesh.set_next(halfedges[h], halfedges[next_in_triangle(h)]);
    }
  }
  close_borders(mesh, borders);
  return mesh;
}

} // namespace htloops
