// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/skeletons.h"

#include "draw/tints.h"
#include "write/files.h"
#include "write/mesh_writer.h"
#include "write/skeleton_formats.h"
#include "write/tables.h"

#include <algorithm>
#include <utility>

namespace htloops {
namespace {

// A line of a kind, for some points.
Exported_line bone(int kind, std::size_t index, std::vector<Point> points) {
  Exported_line line;
  line.points = std::move(points);
  line.kind = bone_kinds[kind].many;
  line.kind_number = kind;
  line.colour = bone_kinds[kind].colour;
  line.width = bone_kinds[kind].width;
  line.index = index;
  return line;
}

Exported_line line_of(const Skeleton_graph& graph, const Skeleton_arc& arc, std::size_t number) {
  std::vector<Point> points;
  for(const std::size_t point : arc.points)
    points.push_back(graph[point].point);
  if(arc.is_closed())
    points.pop_back();
  Exported_line line = bone(arc.is_on_cycle ? 0 : 1, number, points);
  line.is_closed = arc.is_closed();
  line.length = arc.length;
  return line;
}

// The points `v` of a graph with `is_of_kind(v)` as balls.
template <typename Graph, typename IsOfKind>
void add_balls(const Graph& graph,
               int kind,
               const IsOfKind& is_of_kind,
               bool as_thick,
               Exported_lines& lines) {
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(is_of_kind(v)) {
      lines.lines.push_back(bone(kind, v, {graph[v].point}));
      if(as_thick)
        lines.lines.back().radii = {graph[v].radius};
    }
}

// The legend names kinds in their order.
void sort_by_kind(Exported_lines& lines) {
  std::stable_sort(
      lines.lines.begin(), lines.lines.end(),
      [](const Exported_line& a, const Exported_line& b) { return a.kind_number < b.kind_number; });
}

// Those without an arc, as of a single point, are of the first part.
std::vector<std::size_t> parts_of(std::vector<std::size_t> arcs_of_vertices) {
  std::replace(arcs_of_vertices.begin(), arcs_of_vertices.end(), Skeleton_answer::none,
               std::size_t(0));
  return arcs_of_vertices;
}

void write_skeleton_ply(Text_writer& out, const Skeleton_answer& answer) {
  write_lines_ply(out, lines_of(answer));
}

template <bool is_binary> void write_vtp(Text_writer& out, const Skeleton_answer& answer) {
  write_skeleton_vtp(out, answer, is_binary);
}

void write_skeleton_polylines(Text_writer& out, const Skeleton_answer& answer) {
  write_lines_polylines(out, lines_of(answer));
}

constexpr File_format<void(Text_writer&, const Skeleton_answer&)> skeleton_formats[] = {
    {".swc", write_swc},          {".binary.vtp", write_vtp<true>}, // before what it ends in
    {".vtp", write_vtp<false>},   {".obj", write_skeleton_obj},
    {".ply", write_skeleton_ply}, {".polylines.txt", write_skeleton_polylines},
};

} // namespace

Exported_lines lines_of(const Skeleton_answer& answer) {
  Exported_lines result = {"curve skeleton", "arc", {}};
  for(std::size_t i = 0; i < answer.arcs.size(); ++i)
    result.lines.push_back(line_of(answer.graph, answer.arcs[i], i));
  return result;
}

Exported_lines bones_of(const Skeleton_answer& answer, bool as_thick) {
  Exported_lines bones = lines_of(answer);
  if(as_thick)
    for(std::size_t i = 0; i < answer.arcs.size(); ++i)
      for(std::size_t k = 0; k < bones.lines[i].points.size(); ++k)
        bones.lines[i].radii.push_back(answer.graph[answer.arcs[i].points[k]].radius);
  sort_by_kind(bones);
  for(const int kind : {2, 3, 4})
    add_balls(
        answer.graph, kind,
        [&](auto v) { return name_of_point(answer.graph, v) == std::string(bone_kinds[kind].one); },
        as_thick, bones);
  return bones;
}

Exported_lines bones_of(const Mesh& mesh, const Reeb_answer& answer, bool as_thick) {
  Exported_lines bones = {"Reeb graph", "arc", {}};
  const CGAL::Reeb_arc_shapes shapes = shapes_of_arcs(mesh, answer);
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    bones.lines.push_back(bone(shapes.is_on_cycle[arc.index] ? 0 : 1, arc.index, arc.polyline));
    bones.lines.back().length = arc.length;
    if(as_thick)
      bones.lines.back().radii = arc.radii;
  }
  sort_by_kind(bones);
  using Type = CGAL::Reeb_node_type;
  for(const int kind : {2, 3})
    add_balls(
        answer.graph, kind,
        [&](auto v) {
          const Type type = answer.graph[v].type;
          return kind == 2 ? type == Type::SADDLE : type == Type::MINIMUM || type == Type::MAXIMUM;
        },
        as_thick, bones);
  for(Exported_line& line : bones.lines)
    line.kind += line.kind_number == 2   ? " (saddles)"
                 : line.kind_number == 3 ? " (minima and maxima)"
                                         : "";
  return bones;
}

Skeleton_surface skeleton_surface(const Mesh& mesh, const Skeleton_answer& answer) {
  const std::vector<std::size_t> arcs = arcs_of_vertices(mesh, answer);
  std::vector<Colour> colours = tints_of(mesh, answer, arcs);
  if(colours.empty())
    colours = {plain_tint};
  return {surface_of_labels(mesh, parts_of(arcs)), colours};
}

void check_skeleton_lines_format(const std::string& file) { check_format(file, skeleton_formats); }

void export_skeleton_lines(const std::string& file, const Skeleton_answer& answer) {
  write_file(file, skeleton_formats, answer);
}

void save_skeleton(const std::string& file, const Skeleton_answer& answer, const Run_record& run) {
  constexpr File_format<void()> all[] = {
      {".json", nullptr},          {".csv", nullptr},     {".swc", nullptr},
      {".vtp", nullptr},           {".obj", nullptr},     {".ply", nullptr},
      {".polylines.txt", nullptr}, {".graphml", nullptr}, {".dot", nullptr}};
  format_of(file, all);
  if(boost::algorithm::iends_with(file, ".json"))
    write_skeleton_json(file, answer, run);
  else if(boost::algorithm::iends_with(file, ".csv"))
    write_arc_csv(file, answer);
  else if(boost::algorithm::iends_with(file, ".graphml") ||
          boost::algorithm::iends_with(file, ".dot"))
    write_skeleton_graph(file, answer);
  else
    export_skeleton_lines(file, answer);
}

void export_coloured_mesh(const std::string& file,
                          const Mesh& mesh,
                          const Skeleton_answer& answer) {
  const std::vector<std::size_t> arcs = arcs_of_vertices(mesh, answer);
  const std::vector<Colour> tints = tints_of(mesh, answer, arcs);
  const auto add = [](const char* name, const std::vector<std::size_t>& numbers, auto& properties) {
    std::vector<double>& values = properties.emplace_back(Vertex_property{name, "int", {}}).values;
    for(const std::size_t number : numbers)
      values.push_back(number == Skeleton_answer::none ? -1. : static_cast<double>(number));
  };
  Vertex_properties properties = colour_properties(arcs.size(), [&](std::size_t v) {
    return arcs[v] == Skeleton_answer::none ? plain_tint : tints[arcs[v]];
  });
  add("arc", arcs, properties);
  add("point", answer.vertex_point, properties);
  write_mesh(file, mesh, properties, "parts of a curve skeleton");
}

} // namespace htloops
