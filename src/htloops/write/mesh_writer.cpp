// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/mesh_writer.h"

#include "write/file_format.h"

#include <cstdint>
#include <vector>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::generators::Soup;

void write_point(Text_writer& out, const char* before, const std::array<double, 3>& point) {
  out << before << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
}

void write_triangle(Text_writer& out,
                    const char* before,
                    const std::array<std::uint32_t, 3>& triangle,
                    std::uint32_t first_index) {
  out << before << triangle[0] + first_index << ' ' << triangle[1] + first_index << ' '
      << triangle[2] + first_index << '\n';
}

void write_points_and_triangles(Text_writer& out,
                                const Soup& mesh,
                                const char* before_point,
                                const char* before_triangle,
                                std::uint32_t first_index) {
  for(const auto& point : mesh.points)
    write_point(out, before_point, point);
  for(const auto& triangle : mesh.triangles)
    write_triangle(out, before_triangle, triangle, first_index);
}

void write_off(Text_writer& out, const Soup& mesh) {
  out << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  write_points_and_triangles(out, mesh, "", "3 ", 0);
}

void write_obj(Text_writer& out, const Soup& mesh) {
  write_points_and_triangles(out, mesh, "v ", "f ", 1);
}

void write_ply(Text_writer& out, const Soup& mesh) {
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  write_points_and_triangles(out, mesh, "", "3 ", 0);
}

// The normals are left to the reader, as most readers do not look at them.
void write_stl(Text_writer& out, const Soup& mesh) {
  out << "solid htloops\n";
  for(const auto& triangle : mesh.triangles) {
    out << "facet normal 0 0 0\nouter loop\n";
    for(const std::uint32_t vertex : triangle)
      write_point(out, "vertex ", mesh.points[vertex]);
    out << "endloop\nendfacet\n";
  }
  out << "endsolid htloops\n";
}

constexpr File_format<void(Text_writer&, const Soup&)> formats[] = {
    {".off", write_off},
    {".obj", write_obj},
    {".ply", write_ply},
    {".stl", write_stl},
};

// The standard output has no name that could tell a format.
std::string name_with_format(const std::string& file) { return file == "-" ? "mesh.off" : file; }

Soup soup_of(const Mesh& mesh) {
  Soup soup;
  soup.points.reserve(mesh.number_of_vertices());
  soup.triangles.reserve(mesh.number_of_faces());
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    number[v.idx()] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back({p.x(), p.y(), p.z()});
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back({number[mesh.source(h).idx()], number[mesh.target(h).idx()],
                              number[mesh.target(mesh.next(h)).idx()]});
  }
  return soup;
}

} // namespace

void check_mesh_format(const std::string& file) { format_of(name_with_format(file), formats); }

void write_mesh(const std::string& file, const Soup& mesh) {
  Text_writer out(file);
  format_of(name_with_format(file), formats).write(out, mesh);
  out.finish();
}

void write_mesh(const std::string& file, const Mesh& mesh) { write_mesh(file, soup_of(mesh)); }

} // namespace htloops
