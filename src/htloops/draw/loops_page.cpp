// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/loops_page.h"

#include "write/loop_colours.h"
#include "write/pair_table.h"

#include <string>
#include <vector>

namespace htloops {
namespace {

using CGAL::Loop_type;

// The extents of a box are told in fewer letters than where there is room.
std::vector<std::string> narrow_cells_of(const Listed_pair& pair) {
  std::vector<std::string> cells = cells_of(pair);
  for(std::size_t at; (at = cells.back().find(" x ")) != std::string::npos;)
    cells.back().replace(at, 3, "\u00d7");
  return cells;
}

void add_pairs(htl_window::Scene& scene,
               const Pairs& pairs,
               const Pair_listing& listing,
               const std::string& choice) {
  for(const Table_column& column : pair_columns)
    scene.table.columns.push_back({column.name, column.is_number});
  scene.table.choice = choice;
  add_groups_of_loops(scene);
  for(std::size_t row = 0; row < listing.size(); ++row) {
    const Listed_pair& listed = listing[row];
    scene.table.rows.push_back(narrow_cells_of(listed));
    scene.table.lengths.push_back((std::min)(listed.handle_length, listed.tunnel_length));
    scene.table.numbers.push_back(listed.pair);
    add_loops(scene, pairs[listed.pair], row);
  }
}

void add_group(htl_window::Scene& scene,
               const std::string& name,
               htl_window::Colour colour,
               const std::vector<Loop>& loops) {
  if(loops.empty())
    return;
  scene.groups.push_back({name, colour});
  for(const Loop& loop : loops)
    add_line(scene, loop.points(), true, scene.groups.size() - 1);
}

} // namespace

htl_window::Scene scene_of_loops(const View& view,
                                 const std::string& mesh_file,
                                 const Mesh& mesh,
                                 const Answer& answer,
                                 const Pair_listing& listing,
                                 const std::string& summary,
                                 const std::string& choice) {
  htl_window::Scene scene =
      scene_of(view, "Handle and tunnel loops of", mesh_file, "surface", drawn_surface(mesh));
  add_paragraphs(scene, summary);
  add_pairs(scene, answer.pairs, listing, choice);
  add_group(scene, "boundary curves", colour_of_boundary_curve, answer.boundaries.curves);
  add_group(scene, "their waists", colour_of(Loop_type::BOUNDARY), answer.boundaries.waists);
  return scene;
}

} // namespace htloops
