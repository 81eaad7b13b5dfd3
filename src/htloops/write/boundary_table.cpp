// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/boundary_table.h"

#include "write/table_rows.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace htloops {
namespace {

constexpr Table_column boundary_columns[] = {{"boundary", 8, true},
                                             {"length", 12, true},
                                             {"waist", 12, true},
                                             {"edges", 8, true},
                                             {"centre", 0, false}};

std::string line_of(const std::vector<std::string>& cells, bool has_waists) {
  std::string line;
  for(std::size_t i = 0; i < cells.size(); ++i)
    if(has_waists || i != 2)
      line += (i == 0 ? "" : "  ") + padded(boundary_columns[i], cells[i]);
  return line + "\n";
}

std::string centre_of(const Loop& curve) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(curve.points().begin(), curve.points().end());
  const auto middle = [&box](int i) { return box.min(i) / 2. + box.max(i) / 2.; };
  return formatted("(%.4g, %.4g, %.4g)", middle(0), middle(1), middle(2));
}

} // namespace

std::string table_of_boundaries(const Boundaries& boundaries, bool show_all) {
  const std::vector<Loop>& curves = boundaries.curves;
  if(curves.empty())
    return "";
  const bool has_waists = !boundaries.waists.empty();
  std::vector<std::size_t> order(curves.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_tuple(curves[a].length(), a) < std::make_tuple(curves[b].length(), b);
  });
  std::vector<std::string> names;
  for(const Table_column& column : boundary_columns)
    names.push_back(column.name);
  return line_of(names, has_waists) + table_rows(curves.size(), show_all, [&](std::size_t row) {
           const std::size_t i = order[row];
           return line_of({std::to_string(i), formatted("%.6g", curves[i].length()),
                           has_waists ? formatted("%.6g", boundaries.waists[i].length()) : "",
                           std::to_string(curves[i].size()), centre_of(curves[i])},
                          has_waists);
         });
}

} // namespace htloops
