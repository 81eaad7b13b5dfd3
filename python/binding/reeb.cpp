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

#include "htloops/solve/arc_shapes.h"
#include "htloops/solve/reeb_solver.h"

#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace htl_python {
namespace {

using htloops::Mesh;
using htloops::Point;
using htloops::Reeb_answer;

CGAL::Reeb_measure measure_of(const std::string& name) {
  static const std::map<std::string, CGAL::Reeb_measure> measures = {
      {"limbs", CGAL::Reeb_measure::LIMBS},
      {"persistence", CGAL::Reeb_measure::PERSISTENCE},
      {"length", CGAL::Reeb_measure::LENGTH},
      {"area", CGAL::Reeb_measure::AREA},
      {"vertices", CGAL::Reeb_measure::VERTICES}};
  const auto it = measures.find(name);
  if(it == measures.end())
    throw std::invalid_argument(
        "measure is 'limbs', 'persistence', 'length', 'area' or 'vertices', not '" + name + "'");
  return it->second;
}

void append(const Point& p, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
}

py::dict nodes_of(const Reeb_answer& answer) {
  std::vector<double> positions, values;
  std::vector<std::int64_t> at;
  std::vector<std::string> types;
  for(const auto v : CGAL::make_range(vertices(answer.graph))) {
    const auto& node = answer.graph[v];
    append(node.point, positions);
    values.push_back(node.value);
    at.push_back(node.vertex.idx());
    types.push_back(htloops::name_of(node.type));
  }
  py::dict nodes;
  nodes["positions"] = array_of(positions, 3);
  nodes["values"] = array_of(values);
  nodes["vertices"] = array_of(at);
  nodes["types"] = types;
  return nodes;
}

py::dict arcs_of(const Reeb_answer& answer, const htloops::Arc_shapes& shapes) {
  std::vector<std::int64_t> ends, starts = {0}, counts;
  std::vector<double> points, radii, lengths;
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    ends.push_back(static_cast<std::int64_t>(source(e, answer.graph)));
    ends.push_back(static_cast<std::int64_t>(target(e, answer.graph)));
    for(const Point& p : arc.polyline)
      append(p, points);
    const std::vector<double>& radii_of_arc = shapes.radii[arc.index];
    radii.insert(radii.end(), radii_of_arc.begin(), radii_of_arc.end());
    starts.push_back(static_cast<std::int64_t>(radii.size()));
    lengths.push_back(arc.length);
    counts.push_back(static_cast<std::int64_t>(arc.vertices.size()));
  }
  py::dict arcs;
  arcs["ends"] = array_of(ends, 2);
  arcs["points"] = array_of(points, 3);
  arcs["radii"] = array_of(radii);
  arcs["starts"] = array_of(starts);
  arcs["lengths"] = array_of(lengths);
  arcs["numbers_of_vertices"] = array_of(counts);
  arcs["girths"] = array_of(shapes.girths);
  arcs["is_on_cycle"] =
      array_of(std::vector<std::uint8_t>(shapes.is_on_cycle.begin(), shapes.is_on_cycle.end()));
  return arcs;
}

// -1 for vertices without faces.
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
    options.measure = measure_of(*measure);
  options.sources = vertices_of(mesh, sources);
  Reeb_answer answer;
  htloops::Arc_shapes shapes;
  compute(threads, watch, [&] {
    answer = htloops::find_reeb_graph(mesh, options, watch);
    shapes = htloops::shapes_of_arcs(mesh, answer);
  });
  py::dict record;
  record["nodes"] = nodes_of(answer);
  record["arcs"] = arcs_of(answer, shapes);
  record["arc_of_vertex"] = arcs_of_vertices(answer);
  record["values"] = array_of(answer.values);
  record["number_of_cycles"] = htloops::number_of_cycles(answer);
  return record;
}

} // namespace

void add_reeb(py::module_& module) { module.def("reeb", &reeb); }

} // namespace htl_python
