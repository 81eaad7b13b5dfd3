// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/throat_tables.h"

#include "words.h"
#include "write/pair_listing.h"
#include "write/rows.h"

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <iterator>

namespace htloops {
namespace {

CGAL::Bbox_3 box_of(const Loop& loop) {
  return CGAL::bbox_3(loop.points().begin(), loop.points().end());
}

const char* name_of_side(const Throats& throats, const Throat& throat) {
  return !throats.are_sides_known                        ? "undecided"
         : throat.bounds_inside && throat.bounds_outside ? "both"
         : throat.bounds_inside                          ? "inside"
         : throat.bounds_outside                         ? "outside"
                                                         : "neither";
}

} // namespace

std::vector<std::string> cells_of(const Throats& throats, const Throat& throat) {
  const Point p = middle_of(box_of(throat.loop));
  return {std::to_string(throat.loop.pair_index()),
          formatted("%.6g", throat.loop.length()),
          formatted("%.6g", throat.diameter()),
          std::isinf(throat.prominence) ? "any" : formatted("%.6g", throat.prominence),
          name_of_side(throats, throat),
          throat.pair ? name_of(throat.loop.type()) + (" " + std::to_string(*throat.pair))
          : throat.is_separating ? "none: cuts"
                                 : "others",
          formatted("(%.4g, %.4g, %.4g)", p.x(), p.y(), p.z())};
}

std::string table_of_throats(const Throats& throats, bool show_all) {
  if(!throats.are_wanted)
    return "";
  std::vector<std::vector<std::string>> rows;
  for(const Throat& throat : throats.all)
    rows.push_back(cells_of(throats, throat));
  std::string text =
      table_of({std::begin(throat_columns), std::end(throat_columns)}, rows, show_all) +
      counted(throats.all.size(), "throat", "throats") + formatted(", %.2f s", throats.seconds) +
      "\n";
  for(const Mesh::Vertex_index v : throats.in_vain)
    text += "no loop through vertex " + std::to_string(v.idx()) + " is a throat\n";
  return text;
}

void write_throat_row(Text& out,
                      const std::string& mesh_file,
                      const Throats& throats,
                      const Throat& throat,
                      std::size_t genus) {
  const CGAL::Bbox_3 box = box_of(throat.loop);
  const Point p = middle_of(box);
  out << as_cell(mesh_file) << ',' << throat.loop.pair_index() << ',' << throat.loop.length() << ','
      << throat.diameter() << ',';
  if(std::isinf(throat.prominence))
    out << "inf";
  else
    out << throat.prominence;
  out << ',' << (throat.is_separating ? 1 : 0) << ',' << name_of_side(throats, throat) << ','
      << (throat.pair ? std::to_string(*throat.pair) : "") << ','
      << (throat.pair ? name_of(throat.loop.type()) : "") << ',';
  for(std::size_t i = 0; i < throat.through.size(); ++i)
    out << (i == 0 ? "" : " ") << throat.through[i].idx();
  out << ',' << p.x() << ',' << p.y() << ',' << p.z();
  for(int i = 0; i < 3; ++i)
    out << ',' << box.min(i);
  for(int i = 0; i < 3; ++i)
    out << ',' << box.max(i);
  out << ',' << genus << ',';
}

Json json_of(const Throats& throats, const Throat& throat) {
  Json json = {{"diameter", throat.diameter()},
               {"prominence", throat.prominence},
               {"separating", throat.is_separating},
               {"bounds", name_of_side(throats, throat)}};
  if(std::isinf(throat.prominence))
    json["prominence"] = nullptr;
  if(throat.pair) {
    json["pair"] = *throat.pair;
    json["kind"] = name_of(throat.loop.type());
  }
  if(!throat.through.empty()) {
    json["through"] = Json::array();
    for(const Mesh::Vertex_index v : throat.through)
      json["through"].push_back(v.idx());
  }
  return json;
}

Colour colour_of(const Throat& throat) {
  return throat.is_separating ? colour_of_separating
         : throat.pair        ? colour_of(throat.loop.type())
                              : colour_of(Loop_type::BOUNDARY);
}

} // namespace htloops
