// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/export_lines.h"

#include "draw/export_formats.h"
#include "write/file_format.h"

namespace htloops {
namespace {

// The lines as vertices and edges with a colour per vertex.
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

// The lines as CGAL writes polylines: one per line, of a closed one the first point again at the
// end.
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

constexpr File_format<void(Text_writer&, const Exported_lines&)> line_formats[] = {
    {".ply", write_lines_ply},
    {".obj", write_lines_obj},
    {".polylines.txt", write_lines_polylines},
    {".vtp", write_lines_vtp},
};

} // namespace

void check_lines_format(const std::string& file) { format_of(file, line_formats); }

void export_lines(const std::string& file, const Exported_lines& lines) {
  write_file(file, line_formats, lines);
}

} // namespace htloops
