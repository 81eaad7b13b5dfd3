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

#include "app/solve/reeb_solver.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htl_python {
namespace {

using htloops::Mesh;
using htloops::Point;
using htloops::Reeb_answer;
using namespace py::literals;

constexpr char of_another_mesh[] = "the Reeb graph belongs to another mesh";

py::dict nodes_of(const Reeb_answer& answer) {
  std::vector<Point> positions;
  std::vector<double> values, radii;
  std::vector<std::int64_t> at;
  std::vector<std::string> types;
  for(const auto v : CGAL::make_range(vertices(answer.graph))) {
    const auto& node = answer.graph[v];
    positions.push_back(node.point);
    values.push_back(node.value);
    radii.push_back(node.radius);
    at.push_back(node.vertex.idx());
    types.push_back(htloops::name_of(node.type));
  }
  return py::dict("positions"_a = rows_of<double>(positions), "values"_a = array_of(values),
                  "vertices"_a = array_of(at), "types"_a = types, "radii"_a = array_of(radii));
}

py::dict arcs_of(const Reeb_answer& answer, const CGAL::Reeb_arc_shapes& shapes) {
  std::vector<std::int64_t> ends, starts = {0}, counts;
  std::vector<Point> points;
  std::vector<double> radii, lengths;
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    ends.push_back(static_cast<std::int64_t>(source(e, answer.graph)));
    ends.push_back(static_cast<std::int64_t>(target(e, answer.graph)));
    points.insert(points.end(), arc.polyline.begin(), arc.polyline.end());
    const std::vector<double>& radii_of_arc = shapes.radii[arc.index];
    radii.insert(radii.end(), radii_of_arc.begin(), radii_of_arc.end());
    starts.push_back(static_cast<std::int64_t>(radii.size()));
    lengths.push_back(arc.length);
    counts.push_back(static_cast<std::int64_t>(arc.vertices.size()));
  }
  const std::vector<std::uint8_t> is_on_cycle(shapes.is_on_cycle.begin(), shapes.is_on_cycle.end());
  return py::dict("ends"_a = array_of(ends, 2), "points"_a = rows_of<double>(points),
                  "radii"_a = array_of(radii), "starts"_a = array_of(starts),
                  "lengths"_a = array_of(lengths), "numbers_of_vertices"_a = array_of(counts),
                  "girths"_a = array_of(shapes.girths), "is_on_cycle"_a = array_of(is_on_cycle));
}

py::array_t<std::int64_t> arcs_of_vertices(const Reeb_answer& answer) {
  std::vector<std::int64_t> arcs;
  for(const std::size_t arc : answer.vertex_arc)
    arcs.push_back(arc == Reeb_answer::no_arc ? -1 : static_cast<std::int64_t>(arc));
  return array_of(arcs);
}

template <typename Number>
void take(const py::array_t<Number, py::array::c_style>& array, std::vector<Number>& numbers) {
  numbers.assign(array.data(), array.data() + array.size());
}

py::dict reeb(const py::array& points,
              const py::array& triangles,
              const std::optional<py::array>& values,
              const std::optional<double>& simplify,
              const std::optional<std::string>& measure,
              double shortest_arc,
              bool is_capped,
              bool is_drawn_inside,
              const std::vector<py::ssize_t>& sources,
              int threads,
              Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Reeb_options options;
  if(values) {
    if(values->dtype().kind() == 'i')
      take(py::array_t<std::int64_t, py::array::c_style>(*values), options.integers);
    else
      take(py::array_t<double, py::array::c_style>(*values), options.values);
  }
  if(simplify)
    options.threshold = *simplify;
  if(measure)
    options.measure = htloops::reeb_measures().at(*measure);
  options.shortest_arc = shortest_arc;
  options.allow_parallel_arcs = shortest_arc > 0.;
  options.capped = is_capped;
  options.do_draw_inside = is_drawn_inside;
  options.sources = vertices_of(mesh, sources);
  Reeb_answer answer;
  CGAL::Reeb_arc_shapes shapes;
  compute(threads, watch, [&] {
    answer = htloops::find_reeb_graph(mesh, options, watch);
    shapes = htloops::shapes_of_arcs(mesh, answer);
  });
  return py::dict("nodes"_a = nodes_of(answer), "arcs"_a = arcs_of(answer, shapes),
                  "arc_of_vertex"_a = arcs_of_vertices(answer),
                  "values"_a = array_of(answer.values), "is_contracted"_a = answer.is_contracted,
                  "is_drawn_inside"_a = answer.embedding.has_value(),
                  "number_of_cycles"_a = htloops::number_of_cycles(answer));
}

void add_nodes(const py::dict& nodes, const Mesh& mesh, Reeb_answer& answer) {
  const auto positions = numbers_of<double>(nodes, "positions"),
             values = numbers_of<double>(nodes, "values"),
             radii = numbers_of<double>(nodes, "radii");
  const auto at = numbers_of<std::int64_t>(nodes, "vertices");
  const auto types = nodes["types"].cast<std::vector<std::string>>();
  const std::size_t size = types.size();
  require(positions.size() == 3 * size && values.size() == size && radii.size() == size &&
              at.size() == size,
          of_another_mesh);
  for(std::size_t i = 0; i < size; ++i) {
    auto& node = answer.graph[add_vertex(answer.graph)];
    node.vertex = vertex_of(mesh, static_cast<py::ssize_t>(at[i]));
    node.point = Point(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    node.radius = radii[i];
    node.value = values[i];
    for(const auto type : {CGAL::Reeb_node_type::MINIMUM, CGAL::Reeb_node_type::SADDLE,
                           CGAL::Reeb_node_type::MAXIMUM})
      if(types[i] == htloops::name_of(type))
        node.type = type;
  }
}

void add_arcs(const py::dict& arcs, Reeb_answer& answer) {
  const auto ends = numbers_of<std::int64_t>(arcs, "ends"),
             starts = numbers_of<std::int64_t>(arcs, "starts");
  const auto points = numbers_of<double>(arcs, "points"), radii = numbers_of<double>(arcs, "radii"),
             lengths = numbers_of<double>(arcs, "lengths");
  const std::size_t size = lengths.size();
  const auto number_of_nodes = static_cast<std::int64_t>(num_vertices(answer.graph));
  require(ends.size() == 2 * size && starts.size() == size + 1 && starts.front() == 0 &&
              std::is_sorted(starts.begin(), starts.end()) &&
              starts.back() == static_cast<std::int64_t>(radii.size()) &&
              points.size() == 3 * radii.size(),
          of_another_mesh);
  for(std::size_t i = 0; i < size; ++i) {
    for(const std::int64_t end : {ends[2 * i], ends[2 * i + 1]})
      require(0 <= end && end < number_of_nodes, of_another_mesh);
    const auto e = add_edge(static_cast<std::size_t>(ends[2 * i]),
                            static_cast<std::size_t>(ends[2 * i + 1]), answer.graph)
                       .first;
    auto& arc = answer.graph[e];
    arc.index = i;
    arc.length = lengths[i];
    for(auto k = static_cast<std::size_t>(starts[i]); k < static_cast<std::size_t>(starts[i + 1]);
        ++k) {
      arc.polyline.emplace_back(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
      arc.radii.push_back(radii[k]);
    }
  }
}

// Arcs have their vertices by increasing value.
void give_vertices(const std::vector<std::int64_t>& arc_of_vertex, Reeb_answer& answer) {
  const auto number_of_arcs = static_cast<std::int64_t>(num_edges(answer.graph));
  std::vector<std::vector<Mesh::Vertex_index>> vertices(num_edges(answer.graph));
  for(std::size_t v = 0; v < arc_of_vertex.size(); ++v) {
    const std::int64_t arc = arc_of_vertex[v];
    require(arc < number_of_arcs, of_another_mesh);
    answer.vertex_arc.push_back(arc < 0 ? Reeb_answer::no_arc : static_cast<std::size_t>(arc));
    if(arc >= 0)
      vertices[static_cast<std::size_t>(arc)].push_back(
          Mesh::Vertex_index(static_cast<std::uint32_t>(v)));
  }
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    auto& own = vertices[answer.graph[e].index];
    std::stable_sort(own.begin(), own.end(), [&](Mesh::Vertex_index v, Mesh::Vertex_index w) {
      return answer.values[v.idx()] < answer.values[w.idx()];
    });
    answer.graph[e].vertices = std::move(own);
  }
}

} // namespace

Reeb_answer reeb_answer_of(const py::dict& record, const Mesh& mesh) {
  Reeb_answer answer;
  answer.values = numbers_of<double>(record, "values");
  const auto arc_of_vertex = numbers_of<std::int64_t>(record, "arc_of_vertex");
  require(answer.values.size() == mesh.number_of_vertices() &&
              arc_of_vertex.size() == mesh.number_of_vertices(),
          of_another_mesh);
  add_nodes(record["nodes"], mesh, answer);
  add_arcs(record["arcs"], answer);
  give_vertices(arc_of_vertex, answer);
  answer.is_contracted = record["is_contracted"].cast<bool>();
  if(record["is_drawn_inside"].cast<bool>())
    answer.embedding.emplace();
  return answer;
}

void add_reeb(py::module_& module) { module.def("reeb", &reeb); }

} // namespace htl_python
