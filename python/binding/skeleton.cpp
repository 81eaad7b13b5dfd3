// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "answers.h"
#include "arrays.h"
#include "functions.h"
#include "watch.h"

#include "app/draw/skeletons.h"
#include "app/solve/skeleton_solver.h"
#include "app/write/documents.h"
#include "app/write/skeleton_formats.h"
#include "app/write/tables.h"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

namespace htl_python {
namespace {

using htloops::Mesh;
using htloops::Point;
using htloops::Skeleton_answer;
using htloops::Skeleton_certificate;
using htloops::Skeleton_graph;
using namespace py::literals;

// Numbers of points or arcs, -1 for none.
std::vector<std::int64_t> signed_numbers(const std::vector<std::size_t>& numbers) {
  std::vector<std::int64_t> result;
  for(const std::size_t number : numbers)
    result.push_back(number == Skeleton_answer::none ? -1 : static_cast<std::int64_t>(number));
  return result;
}

void add_graph(const Skeleton_graph& graph, py::dict& record) {
  std::vector<Point> points;
  std::vector<double> radii;
  std::vector<std::int64_t> components, ends;
  std::vector<std::uint8_t> is_inlet;
  for(const auto v : CGAL::make_range(vertices(graph))) {
    points.push_back(graph[v].point);
    radii.push_back(graph[v].radius);
    components.push_back(static_cast<std::int64_t>(graph[v].component));
    is_inlet.push_back(graph[v].is_inlet ? 1 : 0);
  }
  for(const auto e : CGAL::make_range(edges(graph))) {
    ends.push_back(static_cast<std::int64_t>(source(e, graph)));
    ends.push_back(static_cast<std::int64_t>(target(e, graph)));
  }
  record["points"] = rows_of<double>(points);
  record["radii"] = array_of(radii);
  record["components"] = array_of(components);
  record["is_inlet"] = array_of(is_inlet);
  record["edges"] = array_of(ends, 2);
  record["number_of_cycles"] = htloops::number_of_cycles(graph);
}

void add_arcs(const Skeleton_answer& answer, py::dict& record) {
  std::vector<std::int64_t> points, starts = {0};
  std::vector<double> lengths, smallest, means, chords;
  std::vector<std::uint8_t> is_on_cycle;
  for(const htloops::Skeleton_arc& arc : answer.arcs) {
    points.insert(points.end(), arc.points.begin(), arc.points.end());
    starts.push_back(static_cast<std::int64_t>(points.size()));
    lengths.push_back(arc.length);
    smallest.push_back(arc.smallest_radius);
    means.push_back(arc.mean_radius);
    chords.push_back(htloops::chord_of(answer.graph, arc));
    is_on_cycle.push_back(arc.is_on_cycle ? 1 : 0);
  }
  record["arc_points"] = array_of(points);
  record["arc_starts"] = array_of(starts);
  record["lengths"] = array_of(lengths);
  record["smallest_radii"] = array_of(smallest);
  record["mean_radii"] = array_of(means);
  record["chords"] = array_of(chords);
  record["is_on_cycle"] = array_of(is_on_cycle);
}

using Ends = std::pair<std::size_t, std::size_t>;

py::dict record_of_proof(const Skeleton_certificate& certificate) {
  std::vector<Ends> outside;
  for(const auto& edge : certificate.edges_outside)
    outside.push_back(edge.edge);
  return py::dict("connected"_a = certificate.connected, "inside"_a = certificate.inside,
                  "embedded"_a = certificate.embedded, "basis"_a = certificate.basis,
                  "failure"_a = certificate.failure, "taken_alone"_a = certificate.taken_alone,
                  "edges_outside"_a = outside);
}

py::dict curve_skeleton(const py::array& points,
                        const py::array& triangles,
                        double shortest_limb,
                        int threads,
                        Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Skeleton_options options;
  options.shortest_limb = shortest_limb;
  Skeleton_answer answer;
  std::vector<std::size_t> arcs;
  compute(threads, watch, [&] {
    answer = htloops::find_skeleton(mesh, options, watch);
    arcs = htloops::arcs_of_vertices(mesh, answer);
  });
  const auto& statistics = answer.statistics;
  py::dict record("point_of_vertex"_a = array_of(signed_numbers(answer.vertex_point)),
                  "arc_of_vertex"_a = array_of(signed_numbers(arcs)),
                  "certificate"_a = record_of_proof(answer.certificate()),
                  "counts"_a = py::dict("faces"_a = statistics.number_of_faces,
                                        "components"_a = statistics.number_of_components,
                                        "boundaries"_a = statistics.number_of_boundaries,
                                        "genus"_a = statistics.genus,
                                        "balls"_a = statistics.number_of_balls),
                  "shortest_limb"_a = shortest_limb);
  add_graph(answer.graph, record);
  add_arcs(answer, record);
  return record;
}

Skeleton_graph graph_of(const py::dict& record) {
  const std::vector<double> points = numbers_of<double>(record, "points"),
                            radii = numbers_of<double>(record, "radii");
  const std::vector<std::int64_t> components = numbers_of<std::int64_t>(record, "components"),
                                  ends = numbers_of<std::int64_t>(record, "edges");
  const std::vector<std::uint8_t> is_inlet = numbers_of<std::uint8_t>(record, "is_inlet");
  const std::size_t size = radii.size();
  require(points.size() == 3 * size && components.size() == size && is_inlet.size() == size,
          "the arrays of the skeleton are inconsistent");
  for(const std::int64_t end : ends)
    require(end >= 0 && end < static_cast<std::int64_t>(size),
            "the skeleton has edges at points that do not exist");
  Skeleton_graph graph(size);
  for(std::size_t i = 0; i < radii.size(); ++i) {
    graph[i].point = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    graph[i].radius = radii[i];
    graph[i].component = static_cast<std::size_t>(components[i]);
    graph[i].is_inlet = is_inlet[i] != 0;
  }
  for(std::size_t i = 0; i < ends.size(); i += 2)
    add_edge(static_cast<std::size_t>(ends[i]), static_cast<std::size_t>(ends[i + 1]), graph);
  return graph;
}

Skeleton_certificate certificate_of(const py::dict& record) {
  const py::dict told = record["certificate"];
  Skeleton_certificate certificate;
  certificate.connected = told["connected"].cast<bool>();
  certificate.inside = told["inside"].cast<bool>();
  certificate.embedded = told["embedded"].cast<bool>();
  certificate.basis = told["basis"].cast<bool>();
  certificate.failure = told["failure"].cast<std::string>();
  certificate.taken_alone = told["taken_alone"].cast<std::string>();
  for(const Ends& ends : told["edges_outside"].cast<std::vector<Ends>>())
    certificate.edges_outside.push_back({ends, std::nullopt});
  return certificate;
}

void save_skeleton(const std::string& file, const py::dict& record, Watch& watch) {
  const Skeleton_answer answer = skeleton_of(record);
  const double shortest_limb = record["shortest_limb"].cast<double>();
  compute(1, watch, [&] {
    htloops::save_skeleton(file, answer, {"", {{"shortest_limb", shortest_limb}}});
    return 0;
  });
}

} // namespace

Skeleton_answer skeleton_of(const py::dict& record) {
  Skeleton_answer answer;
  answer.graph = graph_of(record);
  answer.arcs = htloops::arcs_of(answer.graph);
  answer.statistics.certificate = certificate_of(record);
  for(const std::int64_t point : numbers_of<std::int64_t>(record, "point_of_vertex"))
    answer.vertex_point.push_back(point < 0 ? Skeleton_answer::none
                                            : static_cast<std::size_t>(point));
  const py::dict counts = record["counts"];
  answer.statistics.number_of_faces = counts["faces"].cast<std::size_t>();
  answer.statistics.number_of_components = counts["components"].cast<std::size_t>();
  answer.statistics.number_of_boundaries = counts["boundaries"].cast<std::size_t>();
  answer.statistics.genus = counts["genus"].cast<std::size_t>();
  answer.statistics.number_of_balls = counts["balls"].cast<std::size_t>();
  return answer;
}

void add_skeleton(py::module_& module) {
  module.def("curve_skeleton", &curve_skeleton);
  module.def("save_skeleton", &save_skeleton);
}

} // namespace htl_python
