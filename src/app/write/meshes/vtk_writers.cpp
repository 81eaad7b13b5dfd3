// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/Vtk_writer.h"
#include "write/meshes/writers.h"

namespace htloops {
namespace {

void write_points(Vtk_writer& vtk, const Written_mesh& written) {
  vtk.comment(comment_on_unit("", written, ""));
  vtk.points(written.mesh.points, [](const auto& p) { return Point(p[0], p[1], p[2]); });
}

template <bool is_binary> void write_polydata_in(Text_writer& out, const Written_mesh& written) {
  const auto& [points, triangles] = written.mesh;
  Vtk_writer vtp(out, Polydata_size{points.size(), 0, 0, triangles.size()}, is_binary);
  write_points(vtp, written);
  vtp.cells("Polys", triangles);
  vtp.finish();
}

template <bool is_binary> void write_grid_in(Text_writer& out, const Written_mesh& written) {
  const auto& [points, triangles] = written.mesh;
  Vtk_writer vtu(out, Grid_size{points.size(), triangles.size()}, is_binary);
  write_points(vtu, written);
  vtu.grid_cells(triangles, [](const auto&) { return Vtk_cell::TRIANGLE; });
  vtu.finish();
}

} // namespace

void write_polydata(Text_writer& out, const Written_mesh& written) {
  write_polydata_in<false>(out, written);
}
void write_polydata_bytes(Text_writer& out, const Written_mesh& written) {
  write_polydata_in<true>(out, written);
}
void write_grid(Text_writer& out, const Written_mesh& written) {
  write_grid_in<false>(out, written);
}
void write_grid_bytes(Text_writer& out, const Written_mesh& written) {
  write_grid_in<true>(out, written);
}

} // namespace htloops
