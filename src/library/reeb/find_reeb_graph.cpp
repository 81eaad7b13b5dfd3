// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/reeb/find_reeb_graph.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Function_on_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_finishing.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

Function_on_vertices::Function_on_vertices(const Flat_mesh& mesh,
                                           std::vector<std::uint32_t> times,
                                           double ticks)
    : times_(std::move(times))
    , ticks_per_step_(ticks) {
  for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub)
    times_[hub] = times_[middle_of_curve(mesh, hub)];
}

Index Function_on_vertices::middle_of_curve(const Flat_mesh& mesh, Index hub) const {
  std::vector<Index> curve(mesh.ring(hub).begin(), mesh.ring(hub).end());
  const auto middle = curve.begin() + static_cast<std::ptrdiff_t>(curve.size() / 2);
  std::nth_element(curve.begin(), middle, curve.end(), [&](Index u, Index v) {
    return key(u) != key(v) ? key(u) < key(v) : mesh.original[u] < mesh.original[v];
  });
  return *middle;
}

void Function_on_vertices::check_values(const Flat_mesh& mesh) const {
  Index not_finite = no_index;
  for(std::size_t v = 0; v < values_.size(); ++v)
    if(!std::isfinite(values_[v]))
      not_finite = (std::min)(not_finite, mesh.original[v]);
  if(not_finite != no_index)
    throw Invalid_function_exception(not_finite);
}

void Function_on_vertices::lead_over_caps(const Flat_mesh& mesh) {
  for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub) {
    const Index v = middle_of_curve(mesh, hub);
    values_.push_back(values_[v]);
    keys_.push_back(keys_[v]);
  }
}

Found_reeb_graph find_reeb_graph(Execution execution,
                                 const Flat_mesh& mesh,
                                 const Function_on_vertices& function,
                                 Reeb_measure default_measure,
                                 const Reeb_options& options,
                                 Reeb_statistics& statistics) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const Sweep_order order(
      execution, mesh, [&](Index v) { return function.key(v); }, options.capped);
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
  Found_reeb_graph found;
  found.graph =
      Reeb_finishing(execution, mesh, order, graph, function)
          .run(options.measure.value_or(default_measure), options.threshold, options.shortest_arc);
  if(!options.allow_parallel_arcs)
    make_simple(found.graph);
  for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub)
    found.vertices_of_hubs.push_back(function.middle_of_curve(mesh, hub));
  if(mesh.number_of_hubs > 0)
    for(Embedded_reeb_graph::Arc& arc : found.graph.arcs)
      arc.vertices.erase(std::remove_if(arc.vertices.begin(), arc.vertices.end(),
                                        [&](Index v) { return mesh.is_hub(v); }),
                         arc.vertices.end());
  statistics.seconds_of_finishing = std::chrono::duration<double>(Clock::now() - has_swept).count();
  return found;
}

void check(const Reeb_options& options) {
  if(!(options.threshold >= 0. && options.threshold <= 1.))
    throw std::invalid_argument("the threshold of the simplification must be in [0, 1]");
  if(!(options.shortest_arc >= 0.))
    throw std::invalid_argument("the length of the shortest arc must not be negative");
}

std::vector<Index> places_of_sources(const Flat_mesh& mesh,
                                     const std::vector<std::size_t>& sources) {
  if(sources.empty())
    return {};
  std::vector<Index> place;
  for(Index i = 0; i < mesh.first_hub; ++i) {
    place.resize((std::max)(place.size(), std::size_t(mesh.original[i]) + 1), no_index);
    place[mesh.original[i]] = i;
  }
  std::vector<Index> places;
  for(std::size_t v : sources) {
    if(v >= place.size() || place[v] == no_index)
      throw std::invalid_argument("a source vertex is isolated or not in the mesh");
    places.push_back(place[v]);
  }
  return places;
}

} // namespace CGAL::Handle_tunnel_loops::internal
