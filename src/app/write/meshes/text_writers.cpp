// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/meshes/writers.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace htloops {
namespace {

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

} // namespace

std::string comment_on_unit(const char* before, const Written_mesh& written, const char* after) {
  const Unit unit = written.facts.unit;
  return unit == Unit::NONE ? "" : before + std::string("unit: ") + words_of(unit).name + after;
}

// Without a comment, over which some readers stumble.
void write_off(Text_writer& out, const Written_mesh& written) {
  out << (written.properties.empty() ? "OFF\n" : "COFF\n") << written.mesh.points.size() << ' '
      << written.mesh.triangles.size() << " 0\n";
  write_points_and_triangles(out, written, "", "3 ", 0);
}

void write_obj(Text_writer& out, const Written_mesh& written) {
  out << comment_on_unit("# ", written, "\n");
  write_points_and_triangles(out, written, "v ", "f ", 1);
}

void write_ply(Text_writer& out, const Written_mesh& written) {
  out << "ply\nformat ascii 1.0\n";
  if(!written.comment.empty())
    out << "comment " << written.comment << '\n';
  out << comment_on_unit("comment ", written, "\n") << "element vertex "
      << written.mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  for(const Vertex_property& property : written.properties)
    out << "property " << property.type << ' ' << property.name << '\n';
  out << "element face " << written.mesh.triangles.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  write_points_and_triangles(out, written, "", "3 ", 0);
}

// The normals are left to the reader, as most readers do not look at them.
void write_stl_text(Text_writer& out, const Written_mesh& written) {
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

} // namespace htloops
