// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/dual_formats.h"

#include "failure.h"
#include "system/files.h"
#include "write/Vtk_writer.h"
#include "write/documents.h"
#include "write/files.h"
#include "write/meshes/msh_writer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

struct Written_cuts
{
  const std::string& file;
  const Mesh& mesh;
  const Dual_cuts& duals;
};

std::uint32_t number_of(Mesh::Vertex_index v) { return static_cast<std::uint32_t>(v.idx()); }

std::array<std::uint32_t, 2> ends_of(const Mesh& mesh, Mesh::Halfedge_index h) {
  return {number_of(mesh.source(h)), number_of(mesh.target(h))};
}

std::array<std::uint32_t, 3> corners_of(const Mesh& mesh, Mesh::Face_index f) {
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return {number_of(mesh.source(h)), number_of(mesh.target(h)),
          number_of(mesh.target(mesh.next(h)))};
}

// ---- MSH

std::string name_of_loop(const Loop& loop) {
  return name_of(loop.type()) + (" " + std::to_string(loop.pair_index()));
}

// A line can only say that it counts twice by being there twice.
Named_edges group_of(const Dual_cut& cut, const Written_cuts& written) {
  constexpr std::int64_t most_times = 1000;
  Named_edges group = {"cut " + name_of_loop(cut.loop), {}};
  for(const auto& [halfedge, times] : cut.edges) {
    if(times > most_times)
      throw wrong_usage("cannot write " + written.file + ": the " + group.name + " runs " +
                        std::to_string(times) +
                        " times along an edge, too often for lines: use .vtu or .json");
    group.edges.insert(group.edges.end(), static_cast<std::size_t>(times),
                       ends_of(written.mesh, halfedge));
  }
  return group;
}

Named_edges group_of(const Loop& boundary, const Mesh& mesh) {
  Named_edges group = {name_of_loop(boundary), {}};
  std::vector<std::uint32_t> vertices;
  for(const Loop::Step& step : boundary.steps())
    vertices.push_back(ends_of(mesh, step.halfedge)[step.ratio == 0. ? 0 : 1]);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    group.edges.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
  return group;
}

template <void (*write)(Text_writer&, const generators::Soup&, const Named_groups&)>
void write_dual_msh(Text_writer& out, const Written_cuts& written) {
  generators::Soup soup;
  for(const Point& p : written.mesh.points())
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const Mesh::Face_index f : written.mesh.faces())
    soup.triangles.push_back(corners_of(written.mesh, f));
  Named_groups groups;
  for(const Dual_cut& cut : written.duals.cuts)
    groups.edges.push_back(group_of(cut, written));
  for(const Loop& boundary : written.duals.boundaries)
    groups.edges.push_back(group_of(boundary, written.mesh));
  write(out, soup, groups);
}

// ---- VTK

/// A line of a cut, or a triangle of the mesh.
struct Dual_cell
{
  std::array<std::uint32_t, 3> points = {};
  bool is_line = false;
  std::int64_t cut = -1, loop = -1, index = -1, jump = 0, left = -1, right = -1;

  const std::uint32_t* begin() const { return points.data(); }
  const std::uint32_t* end() const { return begin() + size(); }
  std::size_t size() const { return is_line ? 2 : 3; }
};

using Dual_cells = std::vector<Dual_cell>;

Dual_cells dual_lines_of(const Mesh& mesh, const Dual_cuts& duals) {
  std::size_t number_of_lines = 0;
  for(const Dual_cut& cut : duals.cuts)
    number_of_lines += cut.edges.size();
  const auto cell_beside = [&](Mesh::Halfedge_index h) {
    return mesh.is_border(h) ? -1 : static_cast<std::int64_t>(number_of_lines + mesh.face(h).idx());
  };
  Dual_cells lines;
  for(std::size_t i = 0; i < duals.cuts.size(); ++i) {
    const Loop& loop = duals.cuts[i].loop;
    for(const auto& [h, times] : duals.cuts[i].edges) {
      const auto [u, v] = ends_of(mesh, h);
      lines.push_back({{u, v},
                       true,
                       static_cast<std::int64_t>(i),
                       kind_number_of(loop.type()),
                       static_cast<std::int64_t>(loop.pair_index()),
                       times,
                       cell_beside(h),
                       cell_beside(mesh.opposite(h))});
    }
  }
  return lines;
}

Dual_cells triangles_of(const Mesh& mesh) {
  Dual_cells triangles;
  for(const Mesh::Face_index f : mesh.faces())
    triangles.push_back({corners_of(mesh, f)});
  return triangles;
}

void write_cell_data(Vtk_writer& vtk, const Dual_cells& cells) {
  const auto write = [&](const char* name, std::int64_t Dual_cell::*member) {
    vtk.array("Int64", name, cells, [member](const Dual_cell& cell) { return cell.*member; });
  };
  vtk.begin("CellData", " Scalars=\"jump\"");
  write("cut", &Dual_cell::cut);
  write("loop", &Dual_cell::loop);
  write("index", &Dual_cell::index);
  write("jump", &Dual_cell::jump);
  write("left", &Dual_cell::left);
  write("right", &Dual_cell::right);
  vtk.end("CellData");
}

void write_points(Vtk_writer& vtk, const Mesh& mesh) {
  vtk.points(mesh.points(), [](const Point& point) -> const Point& { return point; });
}

template <bool is_binary> void write_dual_vtp(Text_writer& out, const Written_cuts& written) {
  Dual_cells cells = dual_lines_of(written.mesh, written.duals);
  const Dual_cells triangles = triangles_of(written.mesh);
  Vtk_writer vtp(
      out, Polydata_size{written.mesh.number_of_vertices(), 0, cells.size(), triangles.size()},
      is_binary);
  write_points(vtp, written.mesh);
  vtp.cells("Lines", cells);
  vtp.cells("Polys", triangles);
  cells.insert(cells.end(), triangles.begin(), triangles.end());
  write_cell_data(vtp, cells);
  vtp.finish();
}

template <bool is_binary> void write_dual_vtu(Text_writer& out, const Written_cuts& written) {
  Dual_cells cells = dual_lines_of(written.mesh, written.duals);
  const Dual_cells triangles = triangles_of(written.mesh);
  cells.insert(cells.end(), triangles.begin(), triangles.end());
  Vtk_writer vtu(out, Grid_size{written.mesh.number_of_vertices(), cells.size()}, is_binary);
  write_points(vtu, written.mesh);
  vtu.grid_cells(cells, [](const Dual_cell& cell) {
    return cell.is_line ? Vtk_cell::LINE : Vtk_cell::TRIANGLE;
  });
  write_cell_data(vtu, cells);
  vtu.finish();
}

constexpr File_format<void(Text_writer&, const Written_cuts&)> dual_formats[] = {
    {".json", nullptr}, // a document
    {".msh", write_dual_msh<write_msh4>},
    {".msh2", write_dual_msh<write_msh2>},
    {".msh22", write_dual_msh<write_msh2>},
    {".binary.vtu", write_dual_vtu<true>}, // before what it ends in
    {".vtu", write_dual_vtu<false>},
    {".binary.vtp", write_dual_vtp<true>},
    {".vtp", write_dual_vtp<false>},
};

const auto& dual_format_of(const std::string& file) {
  return format_of(path_of(file).has_extension() ? file : file + ".json", dual_formats);
}

} // namespace

void check_dual_format(const std::string& file) {
  if(!file.empty())
    dual_format_of(file);
}

void write_dual_cuts(const std::string& file, const Mesh& mesh, const Dual_cuts& duals) {
  const auto& format = dual_format_of(file);
  if(format.write == nullptr)
    return write_dual_cuts_json(file, mesh, duals);
  Text_writer out(file);
  format.write(out, {file, mesh, duals});
  out.finish();
}

} // namespace htloops
