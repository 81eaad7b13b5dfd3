// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/removal_page.h"

#include "write/removal_table.h"
#include "write/table_rows.h"

#include <string>
#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Refused_handle;
using CGAL::Handle_tunnel_loops::Removal_report;
using CGAL::Handle_tunnel_loops::Removed_handle;

std::string number(double value) { return formatted("%.6g", value); }

void add_row(htl_window::Table& table, std::vector<std::string> cells, double length) {
  table.rows.push_back(std::move(cells));
  table.lengths.push_back(length);
}

void add_row(htl_window::Table& table, const std::string& name, const Removed_handle& handle) {
  add_row(table,
          {name, name_of(handle.by), number(handle.length), number(handle.area),
           number(handle.volume), ""},
          handle.length);
}

void add_row(htl_window::Table& table, const std::string& name, const Refused_handle& handle) {
  add_row(table, {name, "refused", number(handle.length), "", "", handle.reason}, handle.length);
}

template <typename Handle>
void add_handles(htl_window::Scene& scene, const Pairs& pairs, const std::vector<Handle>& handles) {
  for(const Handle& handle : handles) {
    add_loops(scene, pairs[handle.pair], scene.table.rows.size());
    add_row(scene.table, std::to_string(handle.pair), handle);
    scene.table.numbers.push_back(handle.pair);
  }
}

template <typename Neck> void add_necks(htl_window::Scene& scene, const std::vector<Neck>& necks) {
  for(const Neck& neck : necks)
    add_row(scene.table, "neck", neck);
}

} // namespace

Pairs pairs_to_remove(const Pairs& pairs, const Removal_report& report) {
  Pairs chosen;
  for(const Removed_handle& handle : report.removed)
    chosen.push_back(pairs[handle.pair]);
  for(const Refused_handle& handle : report.refused)
    chosen.push_back(pairs[handle.pair]);
  return chosen;
}

void write_removal_page(const std::string& file, const View& view, const Removal_shown& shown) {
  htl_window::Scene scene = scene_of(view, "Handles removed from", shown.mesh_file, "before",
                                     drawn_surface(shown.before));
  add_paragraphs(scene, summary(shown.report));
  scene.surfaces.push_back(surface_of("after", drawn_surface(shown.after)));
  add_groups_of_loops(scene);
  scene.table.columns = {{"pair", true}, {"by", false},    {"length", true},
                         {"area", true}, {"volume", true}, {"why not", false}};
  scene.table.choice = "--pairs";
  add_handles(scene, shown.pairs, shown.report.removed);
  for(htl_window::Line& line : scene.lines)
    line.surface = 0; // these loops are on the surface no more
  add_handles(scene, shown.pairs, shown.report.refused);
  add_necks(scene, shown.report.removed_necks);
  add_necks(scene, shown.report.refused_necks);
  write_page(file, scene);
}

} // namespace htloops
