// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/reeb_exports.h"

#include "draw/export_formats.h"
#include "write/file_format.h"

namespace htloops {
namespace {

void write_graphml(Text_writer& out, const Reeb_answer& answer) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  const auto declare = [&out](const char* id, const char* target, const char* type) {
    out << "<key id=\"" << id << "\" for=\"" << target << "\" attr.name=\"" << id
        << "\" attr.type=\"" << type << "\"/>\n";
  };
  declare("type", "node", "string");
  declare("vertex", "node", "int");
  for(const char* name : {"value", "x", "y", "z"})
    declare(name, "node", "double");
  declare("arc", "edge", "int");
  declare("vertex_count", "edge", "int");
  declare("length", "edge", "double");
  const auto data = [&out](const char* key, const auto& value) {
    out << "<data key=\"" << key << "\">" << value << "</data>";
  };
  out << "<graph edgedefault=\"undirected\">\n";
  for(const auto v : CGAL::make_range(vertices(answer.graph))) {
    const auto& node = answer.graph[v];
    out << "<node id=\"n" << v << "\">";
    data("type", name_of(node.type));
    data("vertex", node.vertex.idx());
    data("value", node.value);
    data("x", node.point.x());
    data("y", node.point.y());
    data("z", node.point.z());
    out << "</node>\n";
  }
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    out << "<edge source=\"n" << source(e, answer.graph) << "\" target=\"n"
        << target(e, answer.graph) << "\">";
    data("arc", arc.index);
    data("vertex_count", arc.vertices.size());
    data("length", arc.length);
    out << "</edge>\n";
  }
  out << "</graph>\n</graphml>\n";
}

// Numbers stand in quotes, as DOT knows none with an exponent.
void write_dot(Text_writer& out, const Reeb_answer& answer) {
  out << "graph reeb {\n";
  for(const auto v : CGAL::make_range(vertices(answer.graph))) {
    const auto& node = answer.graph[v];
    out << "  " << v << " [type=" << name_of(node.type) << ", vertex=" << node.vertex.idx()
        << ", value=\"" << node.value << "\", position=\"" << node.point << "\"];\n";
  }
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    out << "  " << source(e, answer.graph) << " -- " << target(e, answer.graph)
        << " [arc=" << arc.index << ", vertex_count=" << arc.vertices.size() << ", length=\""
        << arc.length << "\"];\n";
  }
  out << "}\n";
}

void write_coloured_ply(Text_writer& out, const Mesh& mesh, const Reeb_answer& answer) {
  out << "ply\nformat ascii 1.0\ncomment parts of a Reeb graph\nelement vertex "
      << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int arc\n"
         "element face "
      << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const std::size_t arc = answer.vertex_arc[v.idx()];
    const bool is_isolated = arc == Reeb_answer::no_arc;
    const auto [red, green, blue] = colour_of_arc(is_isolated ? 0 : arc);
    out << mesh.point(v) << ' ' << int(red) << ' ' << int(green) << ' ' << int(blue) << ' '
        << (is_isolated ? -1ll : static_cast<long long>(arc)) << '\n';
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    out << '3';
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      out << ' ' << v.idx();
    out << '\n';
  }
}

constexpr File_format<void(Text_writer&, const Reeb_answer&)> graph_formats[] = {
    {".graphml", write_graphml},
    {".dot", write_dot},
};

constexpr File_format<void(Text_writer&, const Mesh&, const Reeb_answer&)> coloured_mesh_formats[] =
    {
        {".ply", write_coloured_ply},
};

} // namespace

Exported_lines lines_of(const Reeb_answer& answer) {
  Exported_lines result = {"Reeb graph", "arc", {}};
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    result.lines.push_back(
        {arc.polyline, false, colour_of_arc(arc.index), "arc", 0, arc.index, arc.length});
  }
  return result;
}

void check_graph_format(const std::string& file) { format_of(file, graph_formats); }

void export_graph(const std::string& file, const Reeb_answer& answer) {
  write_file(file, graph_formats, answer);
}

void check_coloured_mesh_format(const std::string& file) { format_of(file, coloured_mesh_formats); }

void export_coloured_mesh(const std::string& file, const Mesh& mesh, const Reeb_answer& answer) {
  write_file(file, coloured_mesh_formats, mesh, answer);
}

} // namespace htloops
