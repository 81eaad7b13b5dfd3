// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ROWS_H
#define HTLOOPS_ROWS_H

#include "solve/answer.h"
#include "write/files.h"
#include "write/pair_listing.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// The header before rows of pairs, as RFC 4180 has it.
constexpr char pair_header[] =
    "mesh,pair,handle_length,tunnel_length,size,handle_bounds,tunnel_bounds,"
    "x,y,z,xmin,ymin,zmin,xmax,ymax,zmax,diameter,diameter_of,axis_x,axis_y,axis_z,"
    "depth,deviation,out_of_roundness,wall_diameter,genus,error";

/// What follows it on the line if handles were measured.
constexpr char measure_header[] =
    ",thickness,thickness_error,thickness_x,thickness_y,thickness_z,clear_width,clear_width_error,"
    "throat_x,throat_y,throat_z,why";
constexpr char cost_header[] =
    ",cut_area,cut_volume,no_cut_because,fill_area,fill_volume,no_fill_because";
constexpr char removal_header[] = ",removed_by,area,volume,refused_because";
/// The last column of all: what lengths are counted in, as far as the file of the mesh says so.
constexpr char unit_header[] = ",unit";

/// What rows tell of.
enum class Row_kind { PAIRS, MEASURED_PAIRS, PAIRS_WITH_COSTS, REMOVALS, THROATS };

/// the whole line.
std::string header_of_rows(Row_kind kind);

/// What is told of one mesh of several.
struct Mesh_line
{
  std::string mesh_file;
  int exit_code = 0;      ///< what follows is known if it is 0
  std::string error = {}; ///< in words; empty if there is none
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  double read_seconds = 0.;
  Answer answer = {};
  Pair_listing listing = {};
};

/// a text as a cell of CSV, on one line, and no formula: one is preceded by an apostrophe.
std::string as_cell(const std::string& text);

/// writes a row for each listed pair: the mesh, the number, the lengths, the side on which each
/// loop bounds, where the shorter loop is, how wide the handle is, with the axis if that is a bore,
/// and the genus. Numbers read back exactly. A mesh of which no pair is listed has a row without
/// pair, and one that has no answer a row with the error. With measures there are
/// the diameters, errors and throats of the balls, or why they are not known; with costs, after
/// these, what either way to remove the handle would change; or what was done. Or a row for each
/// throat in place of pairs.
void write_rows(Text& out, const Mesh_line& line, Row_kind kind);

/// writes an object of JSON on a line.
void write_mesh_line(Text& out, const Mesh_line& line);

/// the names of the columns of the rows that follow, for a person.
std::string header_of_lines(const std::vector<std::string>& mesh_files, Row_kind kind);

/// a row for a mesh; as wide as the names of the files want it. With measures, the least of each.
std::string
row_of(const Mesh_line& line, const std::vector<std::string>& mesh_files, Row_kind kind);

} // namespace htloops

#endif // HTLOOPS_ROWS_H
