// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Caps on the holes of meshes.

#ifndef HTL_TEST_CAPS_ON_HOLES_H
#define HTL_TEST_CAPS_ON_HOLES_H

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

/// the same mesh, with the same halfedges, and a fan in each hole.
template <typename TriangleMesh> TriangleMesh with_caps(TriangleMesh mesh) {
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> borders;
  for(const auto h : halfedges(mesh))
    if(is_border(h, mesh))
      borders.push_back(h);
  for(const auto h : borders)
    if(is_border(h, mesh)) {
      CGAL::Euler::fill_hole(h, mesh);
      const auto hub = target(CGAL::Euler::add_center_vertex(h, mesh), mesh);
      put(CGAL::vertex_point, mesh, hub, get(CGAL::vertex_point, mesh, target(h, mesh)));
    }
  return mesh;
}

#endif // HTL_TEST_CAPS_ON_HOLES_H
