// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/lines.h"

#include "write/tables.h"
#include "write/throat_tables.h"

namespace htloops {
namespace {

void add_lines(Exported_lines& lines, const Pair& pair, std::size_t index) {
  for(const Loop_type type : loop_types)
    lines.lines.push_back({pair.loop(type).points(), true, colour_of(type), name_of(type),
                           kind_number_of(type), index, pair.loop(type).length()});
}

// The lines as line elements, each an object with a name.
void write_lines_obj(Text_writer& out, const Exported_lines& lines) {
  out << "# " << lines.title << '\n';
  std::size_t first = 1;
  for(const Exported_line& line : lines.lines) {
    out << "o " << line.kind << '_' << line.index << '\n';
    for(const Point& point : line.points) {
      out << "v " << point;
      for(const unsigned char part : line.colour)
        out << ' ' << part / 255.;
      out << '\n';
    }
    out << 'l';
    for(std::size_t i = 0; i < line.points.size(); ++i)
      out << ' ' << first + i;
    if(line.is_closed)
      out << ' ' << first;
    out << '\n';
    first += line.points.size();
  }
}

// The lines as lines of a VTK PolyData with their kind, index and length. A closed line names its
// first point again at the end.
template <bool is_binary> void write_lines_vtp(Text_writer& out, const Exported_lines& lines) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> cells;
  for(const Exported_line& line : lines.lines) {
    cells.emplace_back();
    for(std::size_t i = 0; i <= line.number_of_edges(); ++i)
      cells.back().push_back(points.size() + i % line.points.size());
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  Vtk_writer vtp(out, Polydata_size{points.size(), 0, cells.size()}, is_binary);
  vtp.points(points, [](const Point& point) -> const Point& { return point; });
  vtp.cells("Lines", cells);
  vtp.begin("CellData", " Scalars=\"kind\"");
  vtp.array("UInt8", "kind", lines.lines,
            [](const Exported_line& line) { return line.kind_number; });
  vtp.array("Int64", lines.index_name, lines.lines,
            [](const Exported_line& line) { return line.index; });
  vtp.array("Float64", "length", lines.lines,
            [](const Exported_line& line) { return line.length; });
  vtp.end("CellData");
  vtp.finish();
}

constexpr File_format<void(Text_writer&, const Exported_lines&)> line_formats[] = {
    {".ply", write_lines_ply},
    {".obj", write_lines_obj},
    {".polylines.txt", write_lines_polylines},
    {".binary.vtp", write_lines_vtp<true>}, // before what it ends in
    {".vtp", write_lines_vtp<false>},
};

} // namespace

std::size_t Exported_lines::number_of_points() const {
  std::size_t count = 0;
  for(const Exported_line& line : lines)
    count += line.points.size();
  return count;
}

std::size_t Exported_lines::number_of_edges() const {
  std::size_t count = 0;
  for(const Exported_line& line : lines)
    count += line.number_of_edges();
  return count;
}

Exported_lines lines_of(const Pairs& pairs) {
  Exported_lines result = {"handle and tunnel loops", "pair", {}};
  for(const Pair& pair : pairs)
    add_lines(result, pair, pair.handle().pair_index());
  return result;
}

Exported_lines lines_of(const Throats& throats) {
  Exported_lines result = {"throats", "throat", {}};
  for(const Throat& throat : throats.all)
    result.lines.push_back({throat.loop.points(), true, colour_of(throat), "throat", 4,
                            throat.loop.pair_index(), throat.loop.length()});
  return result;
}

std::string label_of(const Listed_pair& listed, Loop_type type) {
  const std::string number = std::to_string(listed.pair) + ": ";
  const bool is_handle = type == Loop_type::HANDLE, is_bore = listed.hole.bore.has_value(),
             is_shorter = is_handle == (listed.handle_length <= listed.tunnel_length);
  if(const auto& measure = listed.measure) {
    if(measure->thickness && is_handle)
      return number + words_of(measure->thickness_range, three_digits) + " thick";
    if(const auto& ball = measure->clear_width; ball && !is_bore && !is_handle)
      return number + words_of(measure->clear_width_range, three_digits) + " wide";
  }
  if(is_bore ? !is_handle : is_shorter && !listed.measure)
    return number +
           "d = " + three_digits(is_handle ? listed.hole.wall_diameter : listed.hole.diameter);
  return std::to_string(listed.pair);
}

Exported_lines lines_of(const Answer& answer, const Pair_listing& listing) {
  if(answer.throats.are_wanted)
    return lines_of(answer.throats);
  Exported_lines result = {"handle and tunnel loops", "pair", {}};
  for(const Listed_pair& listed : listing)
    add_lines(result, answer.pairs[listed.pair], listed.pair);
  const auto add = [&result](const std::vector<Loop>& loops, const auto& colour, const char* kind,
                             int number) {
    for(const Loop& loop : loops)
      result.lines.push_back(
          {loop.points(), true, colour, kind, number, loop.pair_index(), loop.length()});
  };
  add(answer.boundaries.curves, colour_of_boundary_curve, "boundary", 2);
  add(answer.boundaries.waists, colour_of(Loop_type::BOUNDARY), "waist", 3);
  return result;
}

void write_lines_ply(Text_writer& out, const Exported_lines& lines) {
  out << "ply\nformat ascii 1.0\ncomment " << lines.title << "\nelement vertex "
      << lines.number_of_points()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement edge "
      << lines.number_of_edges() << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for(const Exported_line& line : lines.lines) {
    const auto [red, green, blue] = line.colour;
    for(const Point& point : line.points)
      out << point << ' ' << int(red) << ' ' << int(green) << ' ' << int(blue) << '\n';
  }
  std::size_t first = 0;
  for(const Exported_line& line : lines.lines) {
    for(std::size_t i = 0; i < line.number_of_edges(); ++i)
      out << first + i << ' ' << first + (i + 1) % line.points.size() << '\n';
    first += line.points.size();
  }
}

// One per line, of a closed one the first point again at the end.
void write_lines_polylines(Text_writer& out, const Exported_lines& lines) {
  for(const Exported_line& line : lines.lines) {
    out << line.number_of_edges() + 1;
    for(const Point& point : line.points)
      out << ' ' << point;
    if(line.is_closed)
      out << ' ' << line.points.front();
    out << '\n';
  }
}

void check_lines_format(const std::string& file) { check_format(file, line_formats); }

void export_lines(const std::string& file, const Exported_lines& lines) {
  write_file(file, line_formats, lines);
}

} // namespace htloops
