// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LIBRARY_BACKEND_H
#define HTLOOPS_LIBRARY_BACKEND_H

#include "solve/backends.h"
#include "solve/stopwatch.h"
#include "solve/vertex_map.h"

#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <cstddef>
#include <functional>
#include <iterator>

namespace htloops {

/// Names the stages to those who watch.
class Show_stages : public CGAL::Handle_tunnel_loops::Default_visitor
{
public:
  explicit Show_stages(Progress& progress)
      : progress_(progress) {}

  void start_stage(CGAL::Handle_tunnel_loops::Stage stage) {
    progress_.start(CGAL::Handle_tunnel_loops::stage_name(stage));
  }

private:
  Progress& progress_;
};

/// The library's solver, as the tag says; what is left to fill in are the backend's name and its
/// number of threads.
template <typename ConcurrencyTag>
Answer solve_with_library(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  namespace parameters = CGAL::parameters;
  Show_stages visitor(progress);
  const auto watched = parameters::callback(progress.callback()).visitor(std::ref(visitor));
  const auto kind = parameters::basis_kind(options.basis_kind, watched);
  const CGAL::Handle_tunnel_loops::Solver_options& how = options;
  const auto np = parameters::solver_options(how, kind);

  Answer answer;
  const Stopwatch stopwatch;
  const Mesh::Vertex_index seed =
      options.seed.value_or(boost::graph_traits<Mesh>::null_vertex()); // the solver's choice
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(ConcurrencyTag(), mesh, np);
  const auto from_seed = parameters::seed_vertex(seed, np);
  const auto find = [&](const auto& wanted) {
    solver.template find_loops<ConcurrencyTag>(std::back_inserter(answer.pairs), wanted);
  };
  if(options.do_find_layers) {
    Vertex_layers& told = answer.vertex_layers;
    told.layers.assign(mesh.number_of_vertices(), 0);
    told.times.assign(mesh.number_of_vertices(), -1.);
    find(parameters::vertex_layer_map(
        Vertex_map<std::size_t>{&told.layers},
        parameters::vertex_value_map(Vertex_map<double>{&told.times}, from_seed)));
  } else
    find(from_seed);
  answer.statistics = solver.statistics();
  answer.certificate = solver.certificate();
  answer.total_seconds = stopwatch.seconds();
  progress.end();
  return answer;
}

} // namespace htloops

#endif // HTLOOPS_LIBRARY_BACKEND_H
