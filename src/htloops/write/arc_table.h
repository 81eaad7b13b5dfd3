// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ARC_TABLE_H
#define HTLOOPS_ARC_TABLE_H

#include "solve/reeb_answer.h"
#include "write/table_rows.h"

#include <string>
#include <vector>

namespace htloops {

/// What is told of an arc.
struct Listed_arc
{
  std::size_t arc; ///< its number
  double length;
  double girth; ///< the length of the contour half way
  std::size_t number_of_vertices;
  std::string from, to; ///< its lower node and its upper one: what they are, and their numbers
};

/// the arcs, the longest first.
std::vector<Listed_arc> list_arcs(const Mesh& mesh, const Reeb_answer& answer);

constexpr Table_column arc_columns[] = {{"arc", 5, true},    {"length", 12, true},
                                        {"girth", 12, true}, {"vertices", 9, true},
                                        {"from", 14, false}, {"to", 0, false}};

/// what stands in the columns.
std::vector<std::string> cells_of(const Listed_arc& arc);

std::string table_of_arcs(const std::vector<Listed_arc>& arcs, bool show_all);

/// writes a header and a row for each arc, as RFC 4180 has it.
void write_arc_csv(const std::string& target, const std::vector<Listed_arc>& arcs);

} // namespace htloops

#endif // HTLOOPS_ARC_TABLE_H
