// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/meshes.h"

#include "draw/surfaces.h"
#include "write/Graphml_writer.h"
#include "write/files.h"
#include "write/mesh_writer.h"
#include "write/tables.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;
using namespace std::string_literals;

// Whether a corner of the opened mesh begins at a halfedge, in the order around its target: behind
// the cut, or behind the gap between two halfedges of the border.
bool begins_corner(const Mesh& mesh, Mesh::Halfedge_index h, const std::vector<char>& is_cut) {
  return !mesh.is_border(h) && (is_cut[mesh.edge(h).idx()] || mesh.is_border(mesh.opposite(h)));
}

// Gives numbers to the copies of a vertex: a halfedge that leads to it has that of its corner.
void number_copies(const Mesh& mesh,
                   Mesh::Vertex_index v,
                   const std::vector<char>& is_cut,
                   std::vector<std::uint32_t>& copy,
                   generators::Soup& soup) {
  const Mesh::Halfedge_index some = mesh.halfedge(v);
  Mesh::Halfedge_index first = some;
  while(!begins_corner(mesh, first, is_cut)) {
    first = mesh.opposite(mesh.next(first));
    if(first == some)
      break; // there is one corner only
  }
  std::uint32_t number = static_cast<std::uint32_t>(v.idx());
  Mesh::Halfedge_index h = first;
  do {
    if(h != first && begins_corner(mesh, h, is_cut)) {
      number = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back(soup.points[v.idx()]);
    }
    copy[h.idx()] = number;
    h = mesh.opposite(mesh.next(h));
  } while(h != first);
}

void write_graphml(Text_writer& out, const Reeb_answer& answer) {
  Graphml_writer graphml(out, {{"type", "node", "string"},
                               {"vertex", "node", "int"},
                               {"value", "node", "double"},
                               {"x", "node", "double"},
                               {"y", "node", "double"},
                               {"z", "node", "double"},
                               {"arc", "edge", "int"},
                               {"vertex_count", "edge", "int"},
                               {"length", "edge", "double"}});
  for(const auto v : CGAL::make_range(vertices(answer.graph))) {
    const auto& node = answer.graph[v];
    graphml.begin_node(v);
    graphml.data("type", name_of(node.type));
    graphml.data("vertex", node.vertex.idx());
    graphml.data("value", node.value);
    graphml.data("x", node.point.x());
    graphml.data("y", node.point.y());
    graphml.data("z", node.point.z());
    graphml.end_node();
  }
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    graphml.begin_edge(source(e, answer.graph), target(e, answer.graph));
    graphml.data("arc", arc.index);
    graphml.data("vertex_count", arc.vertices.size());
    graphml.data("length", arc.length);
    graphml.end_edge();
  }
  graphml.finish();
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

constexpr File_format<void(Text_writer&, const Reeb_answer&)> graph_formats[] = {
    {".graphml", write_graphml},
    {".dot", write_dot},
};

// A dual cut as walks along its edges, those that lead from boundary to boundary first. An edge is
// drawn once, however often the cut runs along it.
std::vector<std::vector<Mesh::Vertex_index>> trails_of(const Mesh& mesh, const Dual_cut& cut) {
  std::map<Mesh::Vertex_index, std::vector<Mesh::Vertex_index>> ways; // onward
  std::map<Mesh::Vertex_index, int> surplus;                          // of ways onward
  for(const auto& [h, times] : cut.edges) {
    ways[mesh.source(h)].push_back(mesh.target(h));
    ++surplus[mesh.source(h)];
    --surplus[mesh.target(h)];
  }
  std::vector<std::vector<Mesh::Vertex_index>> trails;
  const auto walk_from = [&](Mesh::Vertex_index v) {
    trails.push_back({v});
    while(!ways[v].empty()) {
      const Mesh::Vertex_index next = ways[v].back();
      ways[v].pop_back();
      trails.back().push_back(v = next);
    }
  };
  for(const auto& [v, number] : surplus)
    for(int i = 0; i < number; ++i)
      walk_from(v);
  for(const auto& [h, times] : cut.edges)
    if(!ways[mesh.source(h)].empty())
      walk_from(mesh.source(h));
  return trails;
}

} // namespace

void check_opened_mesh_format(const std::string& file) {
  check_mesh_format(file);
  if(boost::algorithm::iends_with(file, ".stl"))
    throw wrong_usage("cannot write " + file +
                      ": STL stores only coordinates, so the cut would close again");
}

generators::Soup opened_mesh(const Mesh& mesh, const std::vector<Mesh::Edge_index>& cut) {
  std::vector<char> is_cut(mesh.number_of_halfedges(), 0);
  for(const Mesh::Edge_index e : cut)
    is_cut[e.idx()] = 1;
  generators::Soup soup;
  for(const Point& p : mesh.points())
    soup.points.push_back({p.x(), p.y(), p.z()});
  std::vector<std::uint32_t> copy(mesh.number_of_halfedges()); // by halfedge with a face
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      number_copies(mesh, v, is_cut, copy, soup);
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back({copy[mesh.prev(h).idx()], copy[h.idx()], copy[mesh.next(h).idx()]});
  }
  return soup;
}

Exported_lines lines_of(const Mesh& mesh, const std::vector<Mesh::Edge_index>& cut) {
  Exported_lines result = {"cut", "edge", {}};
  std::vector<std::size_t> number(mesh.number_of_halfedges());
  std::size_t next = 0;
  for(const Mesh::Edge_index e : edges_by_vertices(mesh))
    number[e.idx()] = next++;
  for(const Mesh::Edge_index e : cut) {
    Exported_line line;
    line.points = {mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))};
    line.colour = {200, 30, 30};
    line.kind = "cut";
    line.index = number[e.idx()];
    result.lines.push_back(line);
  }
  return result;
}

Exported_lines lines_of(const Mesh& mesh, const Dual_cuts& duals) {
  Exported_lines result = {"dual cuts", "index", {}};
  for(const Dual_cut& cut : duals.cuts)
    for(const std::vector<Mesh::Vertex_index>& trail : trails_of(mesh, cut)) {
      const Loop_type type = cut.loop.type();
      Exported_line line;
      line.is_closed = trail.front() == trail.back();
      for(const Mesh::Vertex_index v : trail)
        line.points.push_back(mesh.point(v));
      for(std::size_t i = 1; i < line.points.size(); ++i)
        line.length += std::sqrt(CGAL::squared_distance(line.points[i - 1], line.points[i]));
      if(line.is_closed)
        line.points.pop_back();
      line.colour = colour_of(type);
      line.kind = "cut_"s + name_of(type);
      line.kind_number = kind_number_of(type);
      line.index = cut.loop.pair_index();
      result.lines.push_back(std::move(line));
    }
  return result;
}

void export_selection(const std::string& file,
                      const Mesh& mesh,
                      const std::vector<Mesh::Edge_index>& cut) {
  Text_writer out(file);
  out << "\n\n";
  const char* blank = "";
  for(const Mesh::Edge_index e : cut) {
    out << blank << mesh.vertex(e, 0).idx() << ' ' << mesh.vertex(e, 1).idx();
    blank = " ";
  }
  out << '\n';
  out.finish();
}

Exported_lines lines_of(const Reeb_answer& answer) {
  Exported_lines result = {"Reeb graph", "arc", {}};
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    result.lines.push_back(
        {arc.polyline, false, colour_of_arc(arc.index), "arc", 0, arc.index, arc.length});
  }
  return result;
}

void check_graph_format(const std::string& file) { check_format(file, graph_formats); }

void export_graph(const std::string& file, const Reeb_answer& answer) {
  write_file(file, graph_formats, answer);
}

void export_coloured_mesh(const std::string& file, const Mesh& mesh, const Reeb_answer& answer) {
  Vertex_properties properties = colour_properties(answer.vertex_arc.size(), [&](std::size_t v) {
    return colour_of_arc(answer.vertex_arc[v] == Reeb_answer::no_arc ? 0 : answer.vertex_arc[v]);
  });
  std::vector<double>& arcs = properties.emplace_back(Vertex_property{"arc", "int", {}}).values;
  for(const std::size_t arc : answer.vertex_arc)
    arcs.push_back(arc == Reeb_answer::no_arc ? -1. : static_cast<double>(arc));
  write_mesh(file, mesh, properties, "parts of a Reeb graph");
}

} // namespace htloops
