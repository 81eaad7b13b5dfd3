// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/arc_table.h"

#include "write/text_writer.h"

#include <algorithm>

namespace htloops {
namespace {

std::string name_of_node(const Reeb_answer& answer, std::size_t node) {
  return name_of(answer.graph[node].type) + (" " + std::to_string(node));
}

std::string row(const std::vector<std::string>& cells) {
  std::string line;
  for(std::size_t i = 0; i < cells.size(); ++i) {
    line += (i == 0 ? "" : "  ") + padded(arc_columns[i], cells[i]);
  }
  return line + "\n";
}

} // namespace

std::vector<Listed_arc> list_arcs(const Mesh& mesh, const Reeb_answer& answer) {
  const std::vector<double> girths = girths_of(mesh, answer);
  std::vector<Listed_arc> arcs;
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    arcs.push_back({arc.index, arc.length, girths[arc.index], arc.vertices.size(),
                    name_of_node(answer, source(e, answer.graph)),
                    name_of_node(answer, target(e, answer.graph))});
  }
  std::stable_sort(arcs.begin(), arcs.end(),
                   [](const Listed_arc& a, const Listed_arc& b) { return a.length > b.length; });
  return arcs;
}

std::vector<std::string> cells_of(const Listed_arc& arc) {
  return {std::to_string(arc.arc),
          formatted("%.6g", arc.length),
          formatted("%.6g", arc.girth),
          std::to_string(arc.number_of_vertices),
          arc.from,
          arc.to};
}

std::string table_of_arcs(const std::vector<Listed_arc>& arcs, bool show_all) {
  if(arcs.empty())
    return "";
  std::vector<std::string> names;
  for(const Table_column& column : arc_columns)
    names.push_back(column.name);
  return row(names) +
         table_rows(arcs.size(), show_all, [&](std::size_t i) { return row(cells_of(arcs[i])); });
}

void write_arc_csv(const std::string& target, const std::vector<Listed_arc>& arcs) {
  Text_writer out(target);
  out << "arc,length,girth,vertices,from,to\n";
  for(const Listed_arc& arc : arcs)
    out << arc.arc << ',' << arc.length << ',' << arc.girth << ',' << arc.number_of_vertices << ','
        << arc.from << ',' << arc.to << '\n';
  out.finish();
}

} // namespace htloops
