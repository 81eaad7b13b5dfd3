// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VTK_WRITER_H
#define HTLOOPS_VTK_WRITER_H

#include "Vtk_cell.h"
#include "mesh_types.h"
#include "window/base64.h"
#include "write/bytes.h"
#include "write/files.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace htloops {

/// writes the coordinates of a point, with blanks between them.
inline Text& operator<<(Text& out, const Point& point) {
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

/// Of how many points and cells a VTK PolyData is.
struct Polydata_size
{
  std::size_t points = 0, vertices = 0, lines = 0, polygons = 0;
};

/// The same of a VTK UnstructuredGrid.
struct Grid_size
{
  std::size_t points = 0, cells = 0;
};

/// Writes points, and cells on them, as a VTK PolyData (.vtp) or UnstructuredGrid (.vtu) in a text
/// of XML. Sections come in any order, and arrays in those that they belong to; those of cells of a
/// PolyData have vertices first, then lines, then polygons. Arrays are text, or bytes in base64
/// after their number, which is shorter.
class Vtk_writer
{
public:
  Vtk_writer(Text_writer& out, const Polydata_size& size, bool is_binary = false)
      : Vtk_writer(out, "PolyData", is_binary) {
    out_ << "<Piece NumberOfPoints=\"" << size.points << "\" NumberOfVerts=\"" << size.vertices
         << "\" NumberOfLines=\"" << size.lines << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
         << size.polygons << "\">\n";
  }

  Vtk_writer(Text_writer& out, const Grid_size& size, bool is_binary = false)
      : Vtk_writer(out, "UnstructuredGrid", is_binary) {
    out_ << "<Piece NumberOfPoints=\"" << size.points << "\" NumberOfCells=\"" << size.cells
         << "\">\n";
  }

  /// `attributes` begin with a blank.
  void begin(const std::string& section, const std::string& attributes = "") {
    out_ << '<' << section << attributes << ">\n";
  }
  void end(const std::string& section) { out_ << "</" << section << ">\n"; }

  /// writes a comment, if it has words.
  void comment(const std::string& words) {
    if(!words.empty())
      out_ << "<!-- " << words << " -->\n";
  }

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
      append_bytes(header, std::uint64_t(bytes.size()));
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

  /// writes a section of the cells of a PolyData, of which each is a range of numbers of points.
  template <typename Cells> void cells(const std::string& section, const Cells& cells) {
    begin(section);
    connectivity(cells);
    end(section);
  }

  /// writes the cells of a grid; `type(cell)` is the type of one.
  template <typename Cells, typename Type> void grid_cells(const Cells& cells, Type type) {
    begin("Cells");
    connectivity(cells);
    array("UInt8", "types", cells, [&](const auto& cell) { return static_cast<int>(type(cell)); });
    end("Cells");
  }

  void finish() { out_ << "</Piece>\n</" << type_ << ">\n</VTKFile>\n"; }

private:
  Vtk_writer(Text_writer& out, const char* type, bool is_binary)
      : out_(out)
      , type_(type)
      , is_binary_(is_binary) {
    out_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type << "\" version=\""
         << (is_binary ? "1.0" : "0.1") << "\" byte_order=\"LittleEndian\""
         << (is_binary ? " header_type=\"UInt64\"" : "") << ">\n<" << type << ">\n";
  }

  template <typename Cells> void connectivity(const Cells& cells) {
    using Cell = typename Cells::value_type;
    array("Int64", "connectivity", cells,
          [](const Cell& points) { return Numbers_of_points<Cell>{&points}; });
    std::size_t end_of_cell = 0;
    array("Int64", "offsets", cells,
          [&end_of_cell](const Cell& points) { return end_of_cell += points.size(); });
  }

  // Of a cell.
  template <typename Cell> struct Numbers_of_points
  {
    const Cell* points;

    friend Text& operator<<(Text& out, const Numbers_of_points& numbers) {
      const char* blank = "";
      for(const auto point : *numbers.points) {
        out << blank << point;
        blank = " ";
      }
      return out;
    }
  };

  // As a number of a type.
  template <typename Number>
  static void append(std::string& bytes, const std::string& type, Number value) {
    if(type == "Float64")
      append_bytes(bytes, static_cast<double>(value));
    else if(type == "UInt8")
      append_bytes(bytes, static_cast<std::uint8_t>(value));
    else
      append_bytes(bytes, static_cast<std::int64_t>(value));
  }
  static void append(std::string& bytes, const std::string& type, const Point& point) {
    for(int i = 0; i < 3; ++i)
      append(bytes, type, point[i]);
  }
  template <typename Cell>
  static void
  append(std::string& bytes, const std::string& type, const Numbers_of_points<Cell>& cell) {
    for(const auto point : *cell.points)
      append(bytes, type, point);
  }

  Text_writer& out_;
  const char* type_;
  bool is_binary_;
};

} // namespace htloops

#endif // HTLOOPS_VTK_WRITER_H
