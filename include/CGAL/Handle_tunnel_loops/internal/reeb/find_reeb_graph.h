// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_REEB_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/mean_edge_length.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_finishing.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <chrono>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Sweeps a function and finishes its Reeb graph. `Key` gives the integers that order the vertices,
/// `Value` the values that they stand for.
template <typename Key, typename Value>
Embedded_reeb_graph find_reeb_graph(Execution execution,
                                    const Flat_mesh& mesh,
                                    const Key& key,
                                    const Value& value,
                                    Reeb_measure measure,
                                    double threshold,
                                    Reeb_statistics& statistics) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const Sweep_order order(execution, mesh, key);
  Flat_reeb_graph graph = [&] {
    const std::vector<Star> stars = sweep_stars(execution, mesh, order);
    const std::uint64_t largest_number_of_steps = 8 * std::uint64_t(mesh.neighbor.size());
    Reeb_sweep sweep(mesh, order, stars, largest_number_of_steps, mean_edge_length(mesh));
    Flat_reeb_graph swept = sweep.run();
    statistics.number_of_steps = sweep.number_of_steps();
    statistics.has_used_trees = sweep.has_used_trees();
    return swept;
  }();
  statistics.number_of_critical_nodes = graph.nodes.size();
  const auto has_swept = Clock::now();
  statistics.seconds_of_sweep = std::chrono::duration<double>(has_swept - began).count();
  Embedded_reeb_graph result =
      Reeb_finishing<Value>(execution, mesh, order, graph, value).run(measure, threshold);
  statistics.seconds_of_finishing = std::chrono::duration<double>(Clock::now() - has_swept).count();
  return result;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_REEB_GRAPH_H
