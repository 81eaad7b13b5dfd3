// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LIBRARY_REEB_H
#define HTLOOPS_LIBRARY_REEB_H

#include "solve/progress.h"
#include "solve/reeb_solver.h"
#include "solve/vertex_map.h"

#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/reeb_graph.h>

namespace htloops {

/// what all computations of Reeb graphs are told.
inline auto reeb_parameters(const Reeb_options& options, Progress& progress, Reeb_answer& answer) {
  namespace parameters = CGAL::parameters;
  CGAL::Handle_tunnel_loops::Reeb_options wanted = options;
  wanted.allow_parallel_arcs = true;
  const auto values = parameters::vertex_value_map(Vertex_map<double>{&answer.values},
                                                   parameters::callback(progress.callback()));
  return parameters::reeb_options(
      wanted, parameters::vertex_arc_map(Vertex_map<std::size_t>{&answer.vertex_arc}, values));
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
                                        reeb_parameters(options, progress, answer)));
  answer.backend = answer.statistics.backend;
}

} // namespace htloops

#endif // HTLOOPS_LIBRARY_REEB_H
