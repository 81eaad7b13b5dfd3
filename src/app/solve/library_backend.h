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

#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>
#include <CGAL/reeb_graph.h>

#include <functional>
#include <iterator>
#include <type_traits>

namespace CGAL {
struct Reference_tag;
}

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

/// The library's solver, as the tag says.
template <typename ConcurrencyTag>
Answer solve_with_library(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  namespace parameters = CGAL::parameters;
  Show_stages visitor(progress);
  const auto watched = parameters::callback(progress.callback())
                           .visitor(std::ref(visitor))
                           .maximum_running_time(options.maximum_running_time);
  const auto kind = parameters::basis_kind(options.basis_kind, watched);
  const CGAL::Handle_tunnel_loops::Solver_options& how = options;
  const auto np = parameters::solver_options(how, kind);

  Answer answer;
  const Thread_limit limit(options.number_of_threads);
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
        map_of_vertices(mesh, told.layers),
        parameters::vertex_value_map(map_of_vertices(mesh, told.times), from_seed)));
  } else
    find(from_seed);
  answer.statistics = solver.statistics();
  answer.certificate = solver.certificate();
  answer.total_seconds = stopwatch.seconds();
  constexpr bool is_reference = std::is_same_v<ConcurrencyTag, CGAL::Reference_tag>;
  answer.number_of_threads = is_reference ? 1 : limit.number_of_threads();
  answer.backend = is_reference ? "reference" : answer.statistics.backend;
  if(answer.backend.empty()) // where there is no handle, there is no field to compute
    answer.backend = "host";
  progress.end();
  return answer;
}

/// what all computations of Reeb graphs are told.
inline auto reeb_parameters(const Mesh& mesh,
                            const Reeb_options& options,
                            Progress& progress,
                            Reeb_answer& answer) {
  namespace parameters = CGAL::parameters;
  CGAL::Handle_tunnel_loops::Reeb_options wanted = options;
  wanted.allow_parallel_arcs = true;
  const auto values = parameters::vertex_value_map(map_of_vertices(mesh, answer.values),
                                                   parameters::callback(progress.callback()));
  return parameters::reeb_options(
      wanted, parameters::vertex_arc_map(map_of_vertices(mesh, answer.vertex_arc), values));
}

/// the graph of a diffusion, with fields by whom the tag stands for.
template <typename ConcurrencyTag>
void diffuse_with_library(const Mesh& mesh,
                          const Reeb_options& options,
                          Progress& progress,
                          Reeb_answer& answer) {
  answer.statistics = CGAL::reeb_graph<ConcurrencyTag>(
      mesh, answer.graph,
      CGAL::parameters::source_vertices(options.sources,
                                        reeb_parameters(mesh, options, progress, answer)));
  answer.backend = answer.statistics.backend;
  if(std::is_same_v<ConcurrencyTag, CGAL::Reference_tag>)
    answer.number_of_threads = 1;
}

template <typename ConcurrencyTag>
constexpr Backend library_backend(const char* name, bool is_chosen_by_auto) {
  return {name, is_chosen_by_auto, solve_with_library<ConcurrencyTag>,
          diffuse_with_library<ConcurrencyTag>};
}

} // namespace htloops

#endif // HTLOOPS_LIBRARY_BACKEND_H
