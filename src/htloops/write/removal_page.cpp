// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/removal_page.h"

#include "write/html_page.h"
#include "write/picture_export.h"
#include "write/removal_table.h"
#include "write/table_rows.h"

#include <filesystem>
#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Refused_handle;
using CGAL::Handle_tunnel_loops::Removal_report;
using CGAL::Handle_tunnel_loops::Removed_handle;
using Row = std::vector<std::string>;

std::string number(double value) { return formatted("%.6g", value); }

Row row(const std::string& name, const Removed_handle& handle) {
  return {
      name, name_of(handle.by), number(handle.length), number(handle.area), number(handle.volume),
      ""};
}

Row row(const std::string& name, const Refused_handle& handle) {
  return {name, "refused", number(handle.length), "", "", handle.reason};
}

std::vector<Row> table_of(const Removal_report& report) {
  std::vector<Row> rows = {{"pair", "by", "length", "area", "volume", "why not"}};
  const auto add_handles = [&rows](const auto& handles) {
    for(const auto& handle : handles)
      rows.push_back(row(std::to_string(handle.pair), handle));
  };
  const auto add_necks = [&rows](const auto& necks) {
    for(const auto& neck : necks)
      rows.push_back(row("neck", neck));
  };
  add_handles(report.removed);
  add_necks(report.removed_necks);
  add_handles(report.refused);
  add_necks(report.refused_necks);
  return rows;
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

void write_removal_page(const std::string& file, const Removal_shown& shown) {
  const std::string name = std::filesystem::path(shown.mesh_file).filename().string();
  // Drawn before the page is begun: while a file is unfinished, an interrupt has to wait.
  const std::string before =
      picture_of(shown.before, lines_of(pairs_to_remove(shown.pairs, shown.report)));
  const std::string after = picture_of(shown.after, {});
  Html_page page(file, "Handles removed from " + name);
  page.paragraph(summary(shown.report));
  page.picture(before,
               "before, with the handle loops (red) and tunnel loops (blue) of these handles");
  page.picture(after, "after");
  page.table(table_of(shown.report), 2, 5);
  page.finish();
}

} // namespace htloops
