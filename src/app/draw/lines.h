// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LINES_H
#define HTLOOPS_LINES_H

#include "mesh_types.h"
#include "solve/answer.h"
#include "write/Vtk_writer.h"
#include "write/files.h"
#include "write/pair_listing.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// A polyline that is written to a file or drawn.
struct Exported_line
{
  std::vector<Point> points; ///< of a closed line, the first is not repeated
  bool is_closed = false;
  Colour colour = {0, 0, 0};
  std::string kind;      ///< a word
  int kind_number = 0;   ///< the same as a number
  std::size_t index = 0; ///< of what it stands for
  double length = 0.;
  double width = 1.;              ///< in models, as a multiple of that of others
  std::vector<double> radii = {}; ///< by point, if it is as thick as what is around it

  /// as a closed line has one more edge than an open one.
  std::size_t number_of_edges() const { return points.size() - (is_closed ? 0 : 1); }
};

/// Lines of one sort, and what is said about them in files.
struct Exported_lines
{
  std::string title;
  std::string index_name;
  std::vector<Exported_line> lines;

  std::size_t number_of_points() const;
  std::size_t number_of_edges() const;
};

/// the loops of pairs, which know their numbers; the kind of a handle is 0, that of a tunnel 1.
Exported_lines lines_of(const Pairs& pairs);

/// the throats, which know their numbers, of kind 4.
Exported_lines lines_of(const Throats& throats);

/// the throats if they were asked for; else the loops of the listed pairs, and the boundary curves,
/// of kind 2, and their waists, of kind 3, if there are any.
Exported_lines lines_of(const Answer& answer, const Pair_listing& listing);

/// what stands beside a loop of a pair: its number, and what is measured along this loop; or else
/// the diameter of the handle, if it is taken from this loop.
std::string label_of(const Listed_pair& listed, Loop_type type);

/// throws `Failure` if the name of a file does not tell a format that lines can be written in.
void check_lines_format(const std::string& file);

/// writes them as vertices and edges of PLY, with a colour for each vertex.
void write_lines_ply(Text_writer& out, const Exported_lines& lines);

/// writes them as CGAL writes polylines.
void write_lines_polylines(Text_writer& out, const Exported_lines& lines);

/// writes lines, in the format that the name of the file tells.
void export_lines(const std::string& file, const Exported_lines& lines);

} // namespace htloops

#endif // HTLOOPS_LINES_H
