// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/reeb_json_writer.h"

#include "write/json_writer.h"

namespace htloops {
namespace {

using Graph = CGAL::Reeb_graph<Mesh>;

Json timings(const Reeb_answer& answer, double read_seconds) {
  const auto& statistics = answer.statistics;
  return {{"read", read_seconds},
          {"adaptor", statistics.seconds_of_adaptor},
          {"function", statistics.seconds_of_function},
          {"sweep", statistics.seconds_of_sweep},
          {"finishing", statistics.seconds_of_finishing},
          {"total", answer.total_seconds}};
}

Json json_of_node(const Graph& graph, Graph::vertex_descriptor v) {
  const auto& node = graph[v];
  return {{"id", v},
          {"type", name_of(node.type)},
          {"vertex", node.vertex.idx()},
          {"value", node.value},
          {"position", json_of_point(node.point)}};
}

Json json_of_arc(const Graph& graph, Graph::edge_descriptor e, const std::vector<double>& girths) {
  const auto& arc = graph[e];
  return {{"id", arc.index},
          {"source", source(e, graph)},
          {"target", target(e, graph)},
          {"vertex_count", arc.vertices.size()},
          {"length", arc.length},
          {"girth", girths[arc.index]},
          {"polyline", json_of_points(arc.polyline)}};
}

// Vertices without faces are on no arc: null.
Json json_of_vertex_arc(const std::vector<std::size_t>& vertex_arc) {
  Json array = Json::array();
  for(const std::size_t arc : vertex_arc)
    array.push_back(arc == Reeb_answer::no_arc ? Json() : Json(arc));
  return array;
}

} // namespace

void write_reeb_json(const std::string& target,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     double read_seconds) {
  const Graph& graph = answer.graph;
  const std::vector<double> girths = girths_of(mesh, answer);
  Json_writer out(target);
  out.member("format", "htloops-reeb/1");
  out.member("mesh", json_of_mesh(mesh, answer.statistics));
  out.member("function", answer.function);
  out.member("backend", answer.backend);
  out.member("threads", answer.number_of_threads);
  out.member("timings", timings(answer, read_seconds));
  out.member("cycles", number_of_cycles(answer));
  out.array("nodes", CGAL::make_range(vertices(graph)),
            [&graph](auto v) { return json_of_node(graph, v); });
  out.array("arcs", CGAL::make_range(edges(graph)),
            [&](auto e) { return json_of_arc(graph, e, girths); });
  out.member("vertex_arc", json_of_vertex_arc(answer.vertex_arc));
  out.finish();
}

} // namespace htloops
