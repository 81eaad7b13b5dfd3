// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/skeleton_formats.h"

#include "write/Graphml_writer.h"
#include "write/Vtk_writer.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace htloops {
namespace {

using Numbers = std::vector<std::size_t>;

/// The points of a skeleton as rows of SWC, each after its parent.
class Swc_rows
{
public:
  struct Row
  {
    std::size_t point;
    std::size_t parent; ///< a row; `Skeleton_answer::none` for a root
    bool is_copy;       ///< of a point that is there already, where a cycle is cut
  };

  explicit Swc_rows(const Skeleton_graph& graph)
      : edges_at_(num_vertices(graph))
      , row_of_(num_vertices(graph), Skeleton_answer::none)
      , is_followed_(num_edges(graph), 0) {
    std::size_t number = 0;
    for(const auto e : CGAL::make_range(edges(graph))) {
      edges_at_[source(e, graph)].push_back({number, source(e, graph), target(e, graph)});
      edges_at_[target(e, graph)].push_back({number++, target(e, graph), source(e, graph)});
    }
    for(std::size_t point = 0; point < row_of_.size(); ++point)
      if(row_of_[point] == Skeleton_answer::none)
        add_tree(point);
  }

  const std::vector<Row>& rows() const { return rows_; }

  /// of a point that is no copy.
  std::size_t row_of(std::size_t point) const { return row_of_[point]; }

private:
  struct Edge
  {
    std::size_t number, from, to;
  };

  void add(std::size_t point, std::size_t parent) {
    row_of_[point] = rows_.size();
    rows_.push_back({point, parent, false});
    waiting_.insert(waiting_.end(), edges_at_[point].rbegin(), edges_at_[point].rend());
  }

  // What was found last is followed first: so the points of an arc follow each other.
  void add_tree(std::size_t root) {
    add(root, Skeleton_answer::none);
    while(!waiting_.empty()) {
      const Edge edge = waiting_.back();
      waiting_.pop_back();
      if(std::exchange(is_followed_[edge.number], 1) != 0)
        continue;
      if(row_of_[edge.to] == Skeleton_answer::none)
        add(edge.to, row_of_[edge.from]);
      else
        rows_.push_back({edge.to, row_of_[edge.from], true});
    }
  }

  std::vector<std::vector<Edge>> edges_at_; // by point
  Numbers row_of_;                          // by point
  std::vector<char> is_followed_;           // by edge
  std::vector<Edge> waiting_;
  std::vector<Row> rows_;
};

// Calls `visit(arc, from, to, length)` for all edges.
template <typename Visit> void for_each_edge(const Skeleton_answer& answer, Visit visit) {
  for(std::size_t i = 0; i < answer.arcs.size(); ++i) {
    const Numbers& points = answer.arcs[i].points;
    for(std::size_t k = 1; k < points.size(); ++k)
      visit(i, points[k - 1], points[k],
            distance(answer.graph[points[k - 1]].point, answer.graph[points[k]].point));
  }
}

// Those without edges, which are on no arc.
std::vector<Numbers> lone_points(const Skeleton_graph& graph) {
  std::vector<Numbers> points;
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) == 0)
      points.push_back({v});
  return points;
}

void write_skeleton_graphml(Text_writer& out, const Skeleton_answer& answer) {
  const Skeleton_graph& graph = answer.graph;
  Graphml_writer graphml(out, {{"kind", "node", "string"},
                               {"x", "node", "double"},
                               {"y", "node", "double"},
                               {"z", "node", "double"},
                               {"radius", "node", "double"},
                               {"component", "node", "int"},
                               {"inlet", "node", "boolean"},
                               {"arc", "edge", "int"},
                               {"length", "edge", "double"}});
  for(const auto v : CGAL::make_range(vertices(graph))) {
    graphml.begin_node(v);
    graphml.data("kind", name_of_point(graph, v));
    graphml.data("x", graph[v].point.x());
    graphml.data("y", graph[v].point.y());
    graphml.data("z", graph[v].point.z());
    graphml.data("radius", graph[v].radius);
    graphml.data("component", graph[v].component);
    graphml.data("inlet", graph[v].is_inlet ? "true" : "false");
    graphml.end_node();
  }
  for_each_edge(answer, [&](std::size_t arc, std::size_t from, std::size_t to, double length) {
    graphml.begin_edge(from, to);
    graphml.data("arc", arc);
    graphml.data("length", length);
    graphml.end_edge();
  });
  graphml.finish();
}

// Numbers stand in quotes, as DOT knows none with an exponent.
void write_skeleton_dot(Text_writer& out, const Skeleton_answer& answer) {
  const Skeleton_graph& graph = answer.graph;
  out << "graph skeleton {\n";
  for(const auto v : CGAL::make_range(vertices(graph)))
    out << "  " << v << " [kind=" << name_of_point(graph, v) << ", position=\"" << graph[v].point
        << "\", radius=\"" << graph[v].radius << "\", component=" << graph[v].component << "];\n";
  for_each_edge(answer, [&](std::size_t arc, std::size_t from, std::size_t to, double length) {
    out << "  " << from << " -- " << to << " [arc=" << arc << ", length=\"" << length << "\"];\n";
  });
  out << "}\n";
}

constexpr File_format<void(Text_writer&, const Skeleton_answer&)> skeleton_graph_formats[] = {
    {".graphml", write_skeleton_graphml},
    {".dot", write_skeleton_dot},
};

} // namespace

void write_swc(Text_writer& out, const Skeleton_answer& answer) {
  constexpr int undefined = 0, custom = 7;
  const Swc_rows swc(answer.graph);
  out << "# curve skeleton by htloops: id type x y z radius parent\n"
         "# coordinates and radii are in the unit of the mesh\n"
         "# a point of type 7 repeats an earlier one where a cycle is cut: ids of both\n";
  for(std::size_t i = 0; i < swc.rows().size(); ++i)
    if(swc.rows()[i].is_copy)
      out << "# cycle: " << i + 1 << ' ' << swc.row_of(swc.rows()[i].point) + 1 << '\n';
  std::size_t number = 0;
  for(const Swc_rows::Row& row : swc.rows()) {
    const auto& point = answer.graph[row.point];
    out << ++number << ' ' << (row.is_copy ? custom : undefined) << ' ' << point.point << ' '
        << point.radius << ' ';
    if(row.parent == Skeleton_answer::none)
      out << "-1\n";
    else
      out << row.parent + 1 << '\n';
  }
}

void write_skeleton_vtp(Text_writer& out, const Skeleton_answer& answer, bool is_binary) {
  const Skeleton_graph& graph = answer.graph;
  const auto points = CGAL::make_range(vertices(graph));
  std::vector<Numbers> alone = lone_points(graph), lines;
  std::vector<std::pair<std::int64_t, std::size_t>> cells; // arcs and components
  for(const Numbers& point : alone)
    cells.push_back({-1, graph[point.front()].component});
  for(const Skeleton_arc& arc : answer.arcs) {
    cells.push_back({static_cast<std::int64_t>(lines.size()), arc.component});
    lines.push_back(arc.points);
  }
  Vtk_writer vtp(out, Polydata_size{num_vertices(graph), alone.size(), lines.size()}, is_binary);
  vtp.begin("PointData", " Scalars=\"MaximumInscribedSphereRadius\"");
  vtp.array("Float64", "MaximumInscribedSphereRadius", points,
            [&](auto v) { return graph[v].radius; });
  vtp.array("UInt8", "Inlet", points, [&](auto v) { return graph[v].is_inlet ? 1 : 0; });
  vtp.end("PointData");
  vtp.begin("CellData", " Scalars=\"Arc\"");
  vtp.array("Int64", "Arc", cells, [](const auto& cell) { return cell.first; });
  vtp.array("Int64", "Component", cells, [](const auto& cell) { return cell.second; });
  vtp.end("CellData");
  vtp.points(points, [&](auto v) -> const Point& { return graph[v].point; });
  vtp.cells("Verts", alone);
  vtp.cells("Lines", lines);
  vtp.finish();
}

void write_skeleton_obj(Text_writer& out, const Skeleton_answer& answer) {
  const Skeleton_graph& graph = answer.graph;
  out << "# curve skeleton by htloops\n";
  for(const auto v : CGAL::make_range(vertices(graph)))
    out << "v " << graph[v].point << '\n';
  for(const Numbers& alone : lone_points(graph))
    out << "p " << alone.front() + 1 << '\n';
  for(std::size_t i = 0; i < answer.arcs.size(); ++i) {
    out << "o arc_" << i << "\nl";
    for(const std::size_t point : answer.arcs[i].points)
      out << ' ' << point + 1;
    out << '\n';
  }
}

void check_skeleton_graph_format(const std::string& file) {
  check_format(file, skeleton_graph_formats);
}

void write_skeleton_graph(const std::string& file, const Skeleton_answer& answer) {
  write_file(file, skeleton_graph_formats, answer);
}

} // namespace htloops
