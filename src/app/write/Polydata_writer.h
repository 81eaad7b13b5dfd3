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
#include "window/base64.h"
#include "write/files.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace htloops {

/// writes the coordinates of a point, with blanks between them.
inline Text_writer& operator<<(Text_writer& out, const Point& point) {
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

/// Writes points, and vertices and lines on them, as a VTK PolyData in a text of XML. Sections come
/// in any order, and arrays in those that they belong to; those of cells have vertices first.
/// Arrays are text, or bytes in base64 after their number, which is shorter.
class Polydata_writer
{
public:
  Polydata_writer(Text_writer& out,
                  std::size_t number_of_points,
                  std::size_t number_of_vertices,
                  std::size_t number_of_lines,
                  bool is_binary = false)
      : out_(out)
      , is_binary_(is_binary) {
    out_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\""
         << (is_binary ? "1.0" : "0.1") << "\" byte_order=\"LittleEndian\""
         << (is_binary ? " header_type=\"UInt64\"" : "")
         << ">\n<PolyData>\n"
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
         << " format=\"" << (is_binary_ ? "binary" : "ascii") << "\">\n";
    if(is_binary_) {
      std::string bytes;
      for(const auto& element : range)
        append(bytes, type, value(element));
      std::string header;
      append_bytes(header, std::uint64_t(bytes.size()), 8);
      out_ << htl_window::base64_of(header + bytes) << '\n';
    } else
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
    array("Int64", "connectivity", cells,
          [](const std::vector<std::size_t>& points) { return Numbers_of_points{&points}; });
    std::size_t end_of_cell = 0;
    array("Int64", "offsets", cells, [&end_of_cell](const std::vector<std::size_t>& points) {
      return end_of_cell += points.size();
    });
    end(section);
  }

  void finish() { out_ << "</Piece>\n</PolyData>\n</VTKFile>\n"; }

private:
  // Of a cell.
  struct Numbers_of_points
  {
    const std::vector<std::size_t>* points;

    friend Text_writer& operator<<(Text_writer& out, const Numbers_of_points& numbers) {
      const char* blank = "";
      for(const std::size_t point : *numbers.points) {
        out << blank << point;
        blank = " ";
      }
      return out;
    }
  };

  // The lowest byte first.
  static void append_bytes(std::string& bytes, std::uint64_t bits, int number) {
    for(int i = 0; i < number; ++i)
      bytes += static_cast<char>(bits >> (8 * i) & 255u);
  }

  // As a number of a type.
  template <typename Number>
  static void append(std::string& bytes, const std::string& type, Number value) {
    if(type == "Float64") {
      const double number = static_cast<double>(value);
      std::uint64_t bits;
      static_assert(sizeof bits == sizeof number);
      std::memcpy(&bits, &number, sizeof bits);
      append_bytes(bytes, bits, 8);
    } else
      append_bytes(bytes, static_cast<std::uint64_t>(value), type == "UInt8" ? 1 : 8);
  }
  static void append(std::string& bytes, const std::string& type, const Point& point) {
    for(int i = 0; i < 3; ++i)
      append(bytes, type, point[i]);
  }
  static void append(std::string& bytes, const std::string& type, const Numbers_of_points& cell) {
    for(const std::size_t point : *cell.points)
      append(bytes, type, point);
  }

  Text_writer& out_;
  bool is_binary_;
};

} // namespace htloops

#endif // HTLOOPS_POLYDATA_WRITER_H
