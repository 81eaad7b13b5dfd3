// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/cut_exports.h"

#include "write/file_format.h"
#include "write/mesh_writer.h"

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

void write_selection(Text_writer& out, const Mesh& mesh, const std::vector<Mesh::Edge_index>& cut) {
  out << "\n\n";
  const char* blank = "";
  for(const Mesh::Edge_index e : cut) {
    out << blank << mesh.vertex(e, 0).idx() << ' ' << mesh.vertex(e, 1).idx();
    blank = " ";
  }
  out << '\n';
}

constexpr File_format<void(Text_writer&, const Mesh&, const std::vector<Mesh::Edge_index>&)>
    selection_formats[] = {
        {".selection.txt", write_selection},
};

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
    first = mesh.next_around_target(first);
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
    h = mesh.next_around_target(h);
  } while(h != first);
}

} // namespace

void check_opened_mesh_format(const std::string& file) {
  check_mesh_format(file);
  if(boost::algorithm::iends_with(file, ".stl"))
    throw Failure(Exit_code::WRONG_USAGE,
                  "cannot write " + file +
                      ": STL knows points only, the cut would be closed again");
}

generators::Soup opened_mesh(const Mesh& mesh, const std::vector<Mesh::Edge_index>& cut) {
  std::vector<char> is_cut(mesh.number_of_edges(), 0);
  for(const Mesh::Edge_index e : cut)
    is_cut[e.idx()] = 1;
  generators::Soup soup;
  for(const Point& p : mesh.points())
    soup.points.push_back({p.x(), p.y(), p.z()});
  std::vector<std::uint32_t> copy(mesh.number_of_halfedges());
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
  for(const Mesh::Edge_index e : cut) {
    Exported_line line;
    line.points = {mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))};
    line.colour = {200, 30, 30};
    line.kind = "cut";
    line.index = e.idx();
    result.lines.push_back(line);
  }
  return result;
}

void check_selection_format(const std::string& file) { format_of(file, selection_formats); }

void export_selection(const std::string& file,
                      const Mesh& mesh,
                      const std::vector<Mesh::Edge_index>& cut) {
  write_file(file, selection_formats, mesh, cut);
}

} // namespace htloops
