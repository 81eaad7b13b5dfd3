// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/page_export.h"

#include "draw/mesh_arrays.h"
#include "write/loop_colours.h"
#include "write/text_writer.h"

#include <filesystem>
#include <sstream>

namespace htloops {

htl_window::Scene scene_of(const View& view,
                           const std::string& title,
                           const std::string& mesh_file,
                           const std::string& surface_name,
                           const Drawn_surface& surface) {
  const std::filesystem::path path(mesh_file);
  htl_window::Scene scene;
  scene.title = title + " " + path.filename().string();
  scene.name = path.stem().string();
  const auto [from, up] = whole_view(view, surface);
  scene.view = from;
  scene.up = up;
  scene.surfaces.push_back(surface_of(surface_name, surface));
  return scene;
}

htl_window::Surface surface_of(const std::string& name, const Drawn_surface& surface) {
  return {name, surface.points, surface.triangles, {}, {}};
}

void add_line(htl_window::Scene& scene,
              const std::vector<Point>& points,
              bool is_closed,
              std::size_t group,
              std::size_t row) {
  scene.lines.push_back({coordinates(points), is_closed, group, row});
}

void add_groups_of_loops(htl_window::Scene& scene) {
  scene.groups = {{"handle loops", colour_of(CGAL::Loop_type::HANDLE)},
                  {"tunnel loops", colour_of(CGAL::Loop_type::TUNNEL)}};
}

void add_loops(htl_window::Scene& scene, const Pair& pair, std::size_t row) {
  for(std::size_t group = 0; group < 2; ++group)
    add_line(scene, pair.loop(loop_types[group]).points(), true, group, row);
}

void add_paragraphs(htl_window::Scene& scene, const std::string& text) {
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);)
    scene.paragraphs.push_back(line);
}

// The page is made before its file is begun: while a file is unfinished, an interrupt has to wait.
void write_page(const std::string& file, const htl_window::Scene& scene) {
  const std::string page = page_of(scene);
  Text_writer out(file);
  out << page;
  out.finish();
}

} // namespace htloops
