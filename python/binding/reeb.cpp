// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "arrays.h"
#include "functions.h"
#include "watch.h"

#include "app/solve/reeb_solver.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>

namespace htl_python {
namespace {

using htloops::Mesh;
using htloops::Point;
using htloops::Reeb_answer;
using namespace py::literals;

py::dict nodes_of(const Reeb_answer& answer) {
  std::vector<Point> positions;
  std::vector<double> values;
  std::vector<std::int64_t> at;
  std::vector<std::string> types;
  for(const auto v : CGAL::make_range(vertices(answer.graph))) {
    const auto& node = answer.graph[v];
    positions.push_back(node.point);
    values.push_back(node.value);
    at.push_back(node.vertex.idx());
    types.push_back(htloops::name_of(node.type));
  }
  return py::dict("positions"_a = rows_of<double>(positions), "values"_a = array_of(values),
                  "vertices"_a = array_of(at), "types"_a = types);
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

py::dict reeb(const py::array& points,
              const py::array& triangles,
              const std::optional<py::array_t<double, py::array::c_style>>& values,
              const std::optional<double>& simplify,
              const std::optional<std::string>& measure,
              double shortest_arc,
              bool is_drawn_inside,
              const std::vector<py::ssize_t>& sources,
              int threads,
              Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Reeb_options options;
  if(values)
    options.values.assign(values->data(), values->data() + values->size());
  if(simplify)
    options.threshold = *simplify;
  if(measure)
    options.measure = htloops::reeb_measures().at(*measure);
  options.shortest_arc = shortest_arc;
  options.allow_parallel_arcs = shortest_arc > 0.;
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
                  "values"_a = array_of(answer.values),
                  "number_of_cycles"_a = htloops::number_of_cycles(answer));
}

} // namespace

void add_reeb(py::module_& module) { module.def("reeb", &reeb); }

} // namespace htl_python
