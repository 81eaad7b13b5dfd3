// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_POLYDATA_WRITER_H
#define HTLOOPS_POLYDATA_WRITER_H

#include "mesh_types.h"
#include "write/files.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// writes the coordinates of a point, with blanks between them.
inline Text_writer& operator<<(Text_writer& out, const Point& point) {
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

/// Writes points, and vertices and lines on them, as a VTK PolyData in a text of XML. Sections come
/// in any order, and arrays in those that they belong to; those of cells have vertices first.
class Polydata_writer
{
public:
  Polydata_writer(Text_writer& out,
                  std::size_t number_of_points,
                  std::size_t number_of_vertices,
                  std::size_t number_of_lines)
      : out_(out) {
    out_ << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
            "<Piece NumberOfPoints=\""
         << number_of_points << "\" NumberOfVerts=\"" << number_of_vertices << "\" NumberOfLines=\""
         << number_of_lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
  }

  /// `attributes` begin with a blank.
  void begin(const std::string& section, const std::string& attributes = "") {
    out_ << '<' << section << attributes << ">\n";
  }
  void end(const std::string& section) { out_ << "</" << section << ">\n"; }

  /// writes an array of what `value(element)` is of the elements of a range.
  template <typename Range, typename Value>
  void array(const char* type,
             const std::string& name,
             const Range& range,
             Value value,
             const char* attributes = "") {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << name << "\"" << attributes
         << " format=\"ascii\">\n";
    for(const auto& element : range)
      out_ << value(element) << '\n';
    out_ << "</DataArray>\n";
  }

  /// writes the section of the points, of which `point(element)` is one.
  template <typename Range, typename Point_of> void points(const Range& range, Point_of point) {
    begin("Points");
    array("Float64", "Points", range, point, " NumberOfComponents=\"3\"");
    end("Points");
  }

  /// writes a section of cells, of which each is the numbers of its points.
  void cells(const std::string& section, const std::vector<std::vector<std::size_t>>& cells) {
    begin(section);
    array("Int64", "connectivity", cells, [](const std::vector<std::size_t>& points) {
      std::string line;
      for(const std::size_t point : points)
        line += (line.empty() ? "" : " ") + std::to_string(point);
      return line;
    });
    std::size_t end_of_cell = 0;
    array("Int64", "offsets", cells, [&end_of_cell](const std::vector<std::size_t>& points) {
      return end_of_cell += points.size();
    });
    end(section);
  }

  void finish() { out_ << "</Piece>\n</PolyData>\n</VTKFile>\n"; }

private:
  Text_writer& out_;
};

} // namespace htloops

#endif // HTLOOPS_POLYDATA_WRITER_H
