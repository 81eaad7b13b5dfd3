// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/mesh_writer.h"

#include "write/files.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

/// Properties are as long as `mesh.points`.
struct Written_mesh
{
  const generators::Soup& mesh;
  const Vertex_properties& properties;
  const std::string& comment;
};

void write_point(Text_writer& out, const char* before, const std::array<double, 3>& point) {
  out << before << point[0] << ' ' << point[1] << ' ' << point[2];
}

// Without an exponent, as far as it is of a type that has none.
void write_value(Text_writer& out, const Vertex_property& property, double value) {
  out << ' ';
  if(property.is_real() || std::trunc(value) != value || std::abs(value) > 1e15)
    out << value;
  else
    out << static_cast<long long>(value);
}

void write_points_and_triangles(Text_writer& out,
                                const Written_mesh& written,
                                const char* before_point,
                                const char* before_triangle,
                                std::uint32_t first_index) {
  for(std::size_t v = 0; v < written.mesh.points.size(); ++v) {
    write_point(out, before_point, written.mesh.points[v]);
    for(const Vertex_property& property : written.properties)
      write_value(out, property, property.values[v]);
    out << '\n';
  }
  for(const auto& [a, b, c] : written.mesh.triangles)
    out << before_triangle << a + first_index << ' ' << b + first_index << ' ' << c + first_index
        << '\n';
}

void write_off(Text_writer& out, const Written_mesh& written) {
  out << (written.properties.empty() ? "OFF\n" : "COFF\n") << written.mesh.points.size() << ' '
      << written.mesh.triangles.size() << " 0\n";
  write_points_and_triangles(out, written, "", "3 ", 0);
}

void write_obj(Text_writer& out, const Written_mesh& written) {
  write_points_and_triangles(out, written, "v ", "f ", 1);
}

void write_ply(Text_writer& out, const Written_mesh& written) {
  out << "ply\nformat ascii 1.0\n";
  if(!written.comment.empty())
    out << "comment " << written.comment << '\n';
  out << "element vertex " << written.mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  for(const Vertex_property& property : written.properties)
    out << "property " << property.type << ' ' << property.name << '\n';
  out << "element face " << written.mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  write_points_and_triangles(out, written, "", "3 ", 0);
}

// The normals are left to the reader, as most readers do not look at them.
void write_stl(Text_writer& out, const Written_mesh& written) {
  out << "solid htloops\n";
  for(const auto& triangle : written.mesh.triangles) {
    out << "facet normal 0 0 0\nouter loop\n";
    for(const std::uint32_t vertex : triangle) {
      write_point(out, "vertex ", written.mesh.points[vertex]);
      out << '\n';
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid htloops\n";
}

constexpr File_format<void(Text_writer&, const Written_mesh&)> mesh_formats[] = {
    {".off", write_off},
    {".obj", write_obj},
    {".ply", write_ply},
    {".stl", write_stl},
};

// The standard output has no name that could tell a format.
std::string name_with_format(const std::string& file) { return file == "-" ? "mesh.off" : file; }

const auto& format_of(const std::string& file) {
  return format_of(name_with_format(file), mesh_formats);
}

generators::Soup soup_of(const Mesh& mesh) {
  generators::Soup soup;
  soup.points.reserve(mesh.number_of_vertices());
  soup.triangles.reserve(mesh.number_of_faces());
  for(const Point& p : mesh.points())
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back(
        {mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return soup;
}

void write(const std::string& file, const Written_mesh& written) {
  Text_writer out(file);
  format_of(file).write(out, written);
  out.finish();
}

} // namespace

void check_mesh_format(const std::string& file) {
  check_format(name_with_format(file), mesh_formats);
}

void write_mesh(const std::string& file, const generators::Soup& mesh) {
  write(file, {mesh, {}, ""});
}

Vertex_properties kept_by_format(const std::string& file, const Vertex_properties& properties) {
  const auto& format = format_of(file);
  if(format.write == write_ply)
    return properties;
  Vertex_properties colours;
  if(format.write == write_off)
    for(const char* name : {"red", "green", "blue", "alpha"})
      for(const Vertex_property& property : properties)
        if(property.name == name)
          colours.push_back(property);
  return colours.size() < 3 ? Vertex_properties() : colours;
}

void write_mesh(const std::string& file,
                const Mesh& mesh,
                const Vertex_properties& properties,
                const std::string& comment) {
  write(file, {soup_of(mesh), properties, comment});
}

} // namespace htloops
