// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/arc_surface.h"

#include "draw/level_cutter.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/Face_arcs.h>

#include <cstddef>

namespace htloops {

namespace internal = CGAL::Handle_tunnel_loops::internal;

Arc_surface arc_surface(const Mesh& mesh, const Reeb_answer& answer) {
  Arc_surface result;
  const internal::Vertices_on_arcs vertices(mesh, get(boost::vertex_index, mesh),
                                            map_of_vertices(mesh, answer.vertex_arc),
                                            map_of_vertices(mesh, answer.values));
  internal::Face_arcs arcs(vertices, answer.graph);
  Level_cutter cutter(mesh, answer.values);
  const auto add = [&](const Level_cutter::Triangle& triangle, std::size_t arc) {
    result.triangles.push_back(triangle);
    result.triangle_arcs.push_back(static_cast<std::uint32_t>(arc));
  };
  for(const Mesh::Face_index f : mesh.faces())
    cutter.cut(f, arcs, add);
  result.points = cutter.take_points();
  return result;
}

Drawn_surface drawn_surface(const Arc_surface& surface) {
  Drawn_surface drawn{surface.points, surface.triangles, {}};
  drawn.colours.reserve(drawn.triangles.size());
  for(const std::uint32_t arc : surface.triangle_arcs)
    drawn.colours.push_back(colour_of_arc(arc));
  return drawn;
}

} // namespace htloops
