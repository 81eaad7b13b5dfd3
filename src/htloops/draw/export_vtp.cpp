// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/export_formats.h"

namespace htloops {
namespace {

class Vtp_writer
{
public:
  Vtp_writer(Text_writer& out, const Exported_lines& lines)
      : out_(out)
      , lines_(lines) {}

  void write() {
    out_ << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
            "<Piece NumberOfPoints=\""
         << lines_.number_of_points() << "\" NumberOfVerts=\"0\" NumberOfLines=\""
         << lines_.lines.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
    write_points();
    write_lines();
    write_data();
    out_ << "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

private:
  void begin_array(const char* type, const std::string& name, const char* more = "") {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\"" << more
         << " format=\"ascii\">\n";
  }

  void end_array() { out_ << "</DataArray>\n"; }

  // an array with one value per line, the result of `value(line)`.
  template <typename Value>
  void write_array(const char* type, const std::string& name, const Value& value) {
    begin_array(type, name);
    for(const Exported_line& line : lines_.lines)
      out_ << value(line) << '\n';
    end_array();
  }

  void write_points() {
    out_ << "<Points>\n";
    begin_array("Float64", "Points", " NumberOfComponents=\"3\"");
    for(const Exported_line& line : lines_.lines)
      for(const Point& point : line.points)
        out_ << point << '\n';
    end_array();
    out_ << "</Points>\n";
  }

  // A closed line names its first point again at the end.
  void write_lines() {
    out_ << "<Lines>\n";
    begin_array("Int64", "connectivity");
    std::size_t first = 0;
    for(const Exported_line& line : lines_.lines) {
      for(std::size_t i = 0; i <= line.number_of_edges(); ++i)
        out_ << first + i % line.points.size() << (i < line.number_of_edges() ? ' ' : '\n');
      first += line.points.size();
    }
    end_array();
    std::size_t end = 0;
    write_array("Int64", "offsets",
                [&end](const Exported_line& line) { return end += line.number_of_edges() + 1; });
    out_ << "</Lines>\n";
  }

  void write_data() {
    out_ << "<CellData Scalars=\"kind\">\n";
    write_array("UInt8", "kind", [](const Exported_line& line) { return line.kind_number; });
    write_array("Int64", lines_.index_name, [](const Exported_line& line) { return line.index; });
    write_array("Float64", "length", [](const Exported_line& line) { return line.length; });
    out_ << "</CellData>\n";
  }

  Text_writer& out_;
  const Exported_lines& lines_;
};

} // namespace

void write_lines_vtp(Text_writer& out, const Exported_lines& lines) {
  Vtp_writer(out, lines).write();
}

} // namespace htloops
