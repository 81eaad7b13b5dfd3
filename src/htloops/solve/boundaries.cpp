// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/boundaries.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boundary_loops.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>

namespace htloops {

Boundaries find_boundaries(const Mesh& mesh, bool do_find_waists) {
  using Tag = CGAL::Parallel_if_available_tag;
  Boundaries boundaries;
  CGAL::boundary_loops<Tag>(mesh, std::back_inserter(boundaries.curves));
  if(do_find_waists)
    CGAL::boundary_loops<Tag>(mesh, std::back_inserter(boundaries.waists),
                              CGAL::parameters::do_tighten(true));
  return boundaries;
}

std::vector<std::size_t> components_of_vertices(const Mesh& mesh, std::size_t number_of_them) {
  if(number_of_them <= 1)
    return std::vector<std::size_t>(mesh.number_of_vertices(), 0);
  std::vector<std::size_t> of_face(mesh.number_of_faces());
  const std::size_t bound = CGAL::Polygon_mesh_processing::connected_components(
      mesh, boost::make_iterator_property_map(of_face.begin(), get(CGAL::face_index, mesh)));
  std::vector<std::size_t> number(bound, bound), of_vertex(mesh.number_of_vertices(), bound);
  std::size_t next = 0;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    if(mesh.is_isolated(v))
      continue;
    for(const Mesh::Face_index f : CGAL::faces_around_target(mesh.halfedge(v), mesh)) {
      if(f == Mesh::null_face())
        continue;
      std::size_t& c = number[of_face[f.idx()]];
      if(c == bound)
        c = next++;
      of_vertex[v.idx()] = c;
      break;
    }
  }
  return of_vertex;
}

} // namespace htloops
