// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/reeb_page.h"

#include "draw/arc_surface.h"
#include "draw/page_export.h"

#include <cstddef>

namespace htloops {
namespace {

void add_parts(htl_window::Surface& surface, const Arc_surface& cut, std::size_t number_of_arcs) {
  surface.triangle_parts = cut.triangle_arcs;
  for(std::size_t arc = 0; arc < number_of_arcs; ++arc)
    surface.part_colours.push_back(colour_of_arc(arc));
}

void add_arcs(htl_window::Scene& scene,
              const Reeb_answer& answer,
              const std::vector<Listed_arc>& arcs) {
  for(const Table_column& column : arc_columns)
    scene.table.columns.push_back({column.name, column.is_number});
  std::vector<std::size_t> row_of(arcs.size());
  for(const Listed_arc& arc : arcs) {
    row_of[arc.arc] = scene.table.rows.size();
    scene.table.rows.push_back(cells_of(arc));
    scene.table.lengths.push_back(arc.length);
    scene.table.parts.push_back(arc.arc);
  }
  scene.groups = {{"bones", {30, 30, 30}}};
  for(const auto e : CGAL::make_range(edges(answer.graph)))
    add_line(scene, answer.graph[e].polyline, false, 0, row_of[answer.graph[e].index]);
}

} // namespace

void write_reeb_page(const std::string& file,
                     const View& view,
                     const std::string& mesh_file,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     const std::vector<Listed_arc>& arcs,
                     const std::string& summary) {
  const Arc_surface cut = arc_surface(mesh, answer);
  htl_window::Scene scene =
      scene_of(view, "Reeb graph of", mesh_file, "surface", drawn_surface(cut));
  add_parts(scene.surfaces[0], cut, num_edges(answer.graph));
  add_paragraphs(scene, summary);
  add_arcs(scene, answer, arcs);
  scene.opacity = 0.7;
  write_page(file, scene);
}

} // namespace htloops
