// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/reeb_solver.h"

#include "solve/library_backend.h"

#include <CGAL/reeb_graph_of_function.h>

namespace htloops {

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
  const Stopwatch stopwatch;
  if(has_values) {
    answer.statistics = CGAL::reeb_graph_of_function<CGAL::Parallel_if_available_tag>(
        mesh, map_of_vertices(mesh, options.values), answer.graph,
        reeb_parameters(mesh, options, progress, answer));
    answer.backend = "host";
  } else
    choose_backend(options.backend).diffuse(mesh, options, progress, answer);
  answer.total_seconds = stopwatch.seconds();
  progress.end();
  return answer;
}

} // namespace htloops
