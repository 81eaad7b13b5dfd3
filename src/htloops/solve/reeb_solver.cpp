// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/reeb_solver.h"

#include "solve/stopwatch.h"
#include "solve/thread_limit.h"
#include "solve/vertex_map.h"

#include <CGAL/reeb_graph.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>

namespace htloops {
namespace {

namespace parameters = CGAL::parameters;

template <typename NamedParameters>
void solve(const Mesh& mesh, const NamedParameters& np, Reeb_answer& answer) {
  answer.statistics = CGAL::reeb_graph<CGAL::Parallel_if_available_tag>(mesh, answer.graph, np);
}

} // namespace

const std::map<std::string, CGAL::Reeb_measure>& reeb_measures() {
  static const std::map<std::string, CGAL::Reeb_measure> measures = {
      {"limbs", CGAL::Reeb_measure::LIMBS},
      {"persistence", CGAL::Reeb_measure::PERSISTENCE},
      {"length", CGAL::Reeb_measure::LENGTH},
      {"area", CGAL::Reeb_measure::AREA},
      {"vertices", CGAL::Reeb_measure::VERTICES}};
  return measures;
}

Reeb_answer find_reeb_graph(const Mesh& mesh, const Reeb_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  const bool has_values = !options.values.empty();
  progress.start("reeb");

  Reeb_answer answer;
  answer.function = has_values ? "given" : "diffusion";
  answer.number_of_threads = limit.number_of_threads();
  answer.vertex_arc.assign(mesh.number_of_vertices(), Reeb_answer::no_arc);
  answer.values.assign(mesh.number_of_vertices(), 0.);
  const auto default_measure =
      has_values ? CGAL::Reeb_measure::PERSISTENCE : CGAL::Reeb_measure::LIMBS;
  const auto np = parameters::simplification_threshold(
      options.threshold.value_or(CGAL::Handle_tunnel_loops::default_simplification_threshold),
      parameters::reeb_measure(
          options.measure.value_or(default_measure),
          parameters::vertex_arc_map(
              Vertex_map<std::size_t>{&answer.vertex_arc},
              parameters::vertex_value_map(Vertex_map<double>{&answer.values},
                                           parameters::allow_parallel_arcs(
                                               true, parameters::callback(progress.callback()))))));
  const Stopwatch stopwatch;
  if(has_values) {
    const auto value = [&options](Mesh::Vertex_index v) { return options.values[v.idx()]; };
    solve(mesh,
          parameters::vertex_function_map(
              boost::make_function_property_map<Mesh::Vertex_index, double>(value), np),
          answer);
  } else
    solve(mesh, parameters::source_vertices(options.sources, np), answer);
  answer.total_seconds = stopwatch.seconds();
  progress.end();
  return answer;
}

} // namespace htloops
