// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Vtk_cell.h"
#include "read/Vtk_document.h"
#include "read/meshes/readers.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace htloops {
namespace {

// Or a point, or nothing.
bool is_line(double type) {
  constexpr double types[] = {0, 1, 2, 3, 4, 21, 35, 60, 68, 75};
  return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

bool is_curved_face(double type) {
  constexpr double types[] = {30, 36, 61, 62, 69, 70, 76, 77};
  return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

using Points_of_cell = std::vector<std::size_t>;

class Vtk_reader
{
public:
  explicit Vtk_reader(const Input_file& file)
      : file_(file)
      , document_(file) {}

  Soup read() {
    if(const Xml_tree* surface = document_.data_set("PolyData"))
      document_.for_each_piece(*surface, [this](const Xml_tree& piece) { read_polygons(piece); });
    else if(const Xml_tree* grid = document_.data_set("UnstructuredGrid"))
      document_.for_each_piece(*grid, [this](const Xml_tree& piece) { read_cells(piece); });
    else
      fail_to_read(file_.name(), "it is neither VTK PolyData nor a VTK UnstructuredGrid");
    if(soup_.faces.empty())
      fail_to_read(file_.name(), has_volumes_
                                     ? "it has volume cells but no faces: extract its surface "
                                       "first, for example in ParaView"
                                     : "it has no faces");
    check_corners(file_.name(), soup_);
    if(has_volumes_)
      soup_.facts.unread.push_back("volume cells");
    return std::move(soup_);
  }

private:
  // Returns the number of the first point of the piece.
  std::size_t read_points(const Xml_tree& piece) {
    const std::size_t first = soup_.points.size();
    const std::vector<double> x = document_.points(piece);
    for(std::size_t i = 0; i + 2 < x.size(); i += 3)
      soup_.points.emplace_back(x[i], x[i + 1], x[i + 2]);
    note_data(piece);
    return first;
  }

  void note_data(const Xml_tree& piece) {
    for(const char* section : {"PointData", "CellData"})
      if(const auto arrays = piece.get_child_optional(section))
        if(arrays->count("DataArray") > 0 && soup_.facts.unread.empty())
          soup_.facts.unread = {"point and cell data"};
  }

  void read_polygons(const Xml_tree& piece) {
    const std::size_t first = read_points(piece);
    for(const Points_of_cell& polygon :
        document_.cells(piece, "Polys", first, soup_.points.size() - first))
      soup_.add_face(polygon);
    for(const Points_of_cell& strip :
        document_.cells(piece, "Strips", first, soup_.points.size() - first))
      add_strip(strip);
  }

  // Each triangle has two points of the one before, which it goes around the other way.
  void add_strip(const Points_of_cell& strip) {
    for(std::size_t i = 2; i < strip.size(); ++i)
      soup_.add_face(
          std::array<std::size_t, 3>{strip[i - 2], strip[i - 1 + i % 2], strip[i - i % 2]});
  }

  void read_cells(const Xml_tree& piece) {
    const std::size_t first = read_points(piece);
    const std::vector<Points_of_cell> cells =
        document_.cells(piece, "Cells", first, soup_.points.size() - first);
    const std::vector<double> of_cells = document_.array(piece, "Cells", "types");
    if(of_cells.size() != cells.size())
      fail_to_read(file_.name(), "not all cells have a type");
    for(std::size_t c = 0; c < cells.size(); ++c)
      add_cell(of_cells[c], cells[c]);
  }

  void add_cell(double type, Points_of_cell cell) {
    const auto add = [this, &cell](std::size_t corners) {
      cell.resize((std::min)(corners, cell.size())); // without those within edges
      soup_.add_face(cell);
    };
    switch(static_cast<Vtk_cell>(type >= 0. && type < 256. ? static_cast<int>(type) : 0)) {
    case Vtk_cell::TRIANGLE:
    case Vtk_cell::QUADRATIC_TRIANGLE:
    case Vtk_cell::BIQUADRATIC_TRIANGLE:
      return add(3);
    case Vtk_cell::PIXEL: // it goes row by row
      if(cell.size() == 4)
        std::swap(cell[2], cell[3]);
      return add(4);
    case Vtk_cell::QUAD:
    case Vtk_cell::QUADRATIC_QUAD:
    case Vtk_cell::BIQUADRATIC_QUAD:
      return add(4);
    case Vtk_cell::POLYGON:
      return add(cell.size());
    case Vtk_cell::TRIANGLE_STRIP:
      return add_strip(cell);
    default:
      if(is_curved_face(type))
        fail_to_read(file_.name(), "faces of VTK type " + std::to_string(int(type)) +
                                       " are not supported: triangulate them");
      has_volumes_ = has_volumes_ || !is_line(type);
    }
  }

  const Input_file& file_;
  Vtk_document document_;
  Soup soup_;
  bool has_volumes_ = false;
};

} // namespace

Soup read_vtk(const Input_file& file) { return Vtk_reader(file).read(); }

} // namespace htloops
