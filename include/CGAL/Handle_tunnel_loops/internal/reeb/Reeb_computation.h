// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_COMPUTATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_COMPUTATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/find_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// One computation of a Reeb graph, for one set of named parameters. It asks for nothing but the
/// values of a function.
template <typename TriangleMesh, typename NamedParameters> class Reeb_computation
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Clock = std::chrono::steady_clock;

  template <typename Tag>
  static constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

public:
  Reeb_computation(const Reeb_computation&) = delete;

  Reeb_computation(Execution execution, const TriangleMesh& tm, const NamedParameters& np)
      : execution_(execution)
      , np_(np)
      , vertex_index_(CGAL::get_initialized_vertex_index_map(tm, np))
      , surface_(
            execution,
            tm,
            vertex_index_,
            parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                         get_const_property_map(vertex_point, tm)))
      , traits_(parameters::choose_parameter<Geom_traits>(
            parameters::get_parameter(np, internal_np::geom_traits)))
      , options_(parameters::choose_parameter(
            parameters::get_parameter(np, internal_np::reeb_options), Reeb_options())) {
    check(options_);
    surface_.describe(statistics_);
    statistics_.seconds_of_adaptor = seconds_since(began_);
  }

  /// the vertices at which the parameters want a diffusion to start, if they say so.
  std::vector<Index> sources() const {
    std::vector<std::size_t> given;
    if constexpr(is_given<internal_np::seed_vertex_t>)
      given.push_back(get(vertex_index_, parameters::get_parameter(np_, internal_np::seed_vertex)));
    if constexpr(is_given<internal_np::source_vertices_t>)
      for(vertex_descriptor v : parameters::get_parameter(np_, internal_np::source_vertices))
        given.push_back(get(vertex_index_, v));
    return places_of_sources(surface_.mesh, given);
  }

  /// the graph of a function of the caller.
  template <typename Map, typename Graph>
  Reeb_statistics run_on_function(const Map& map, Graph& graph) {
    const auto began = Clock::now();
    const Function_on_vertices function(surface_.mesh, map, surface_.vertices);
    statistics_.seconds_of_function = seconds_since(began);
    return find(function, Reeb_measure::PERSISTENCE, graph);
  }

  /// the graph of the arrival times that `find_times()` returns, given the mesh and a record of
  /// what it does.
  template <typename FindTimes, typename Graph>
  Reeb_statistics run_on_times(const FindTimes& find_times, double ticks, Graph& graph) {
    const auto began = Clock::now();
    Statistics statistics;
    const Function_on_vertices function(surface_.mesh, find_times(surface_.mesh, statistics),
                                        ticks);
    statistics_.backend = statistics.backend;
    statistics_.fallback = statistics.fallback;
    statistics_.seconds_of_function = seconds_since(began);
    return find(function, Reeb_measure::LIMBS, graph);
  }

private:
  static double seconds_since(Clock::time_point began) {
    return std::chrono::duration<double>(Clock::now() - began).count();
  }

  template <typename Graph>
  Reeb_statistics
  find(const Function_on_vertices& function, Reeb_measure default_measure, Graph& graph) {
    const Flat_mesh& mesh = surface_.mesh;
    auto& vertices = surface_.vertices;
    Found_reeb_graph found =
        find_reeb_graph(execution_, mesh, function, default_measure, options_, statistics_);
    const auto began = Clock::now();
    for(Index v : found.vertices_of_hubs)
      vertices.push_back(vertices[v]);
    Embedded_reeb_graph& flat = found.graph;
    if constexpr(is_given<internal_np::vertex_arc_map_t>) {
      const auto map = parameters::get_parameter(np_, internal_np::vertex_arc_map);
      for(std::size_t a = 0; a < flat.arcs.size(); ++a)
        for(Index v : flat.arcs[a].vertices)
          put(map, vertices[v], a);
    }
    if constexpr(is_given<internal_np::vertex_value_map_t>) {
      const auto map = parameters::get_parameter(np_, internal_np::vertex_value_map);
      for(Index v = 0; v < mesh.first_hub; ++v)
        put(map, vertices[v], function.value(v));
    }
    Reeb_converter<TriangleMesh, Vertex_point_map, Geom_traits>(surface_.point, traits_, mesh,
                                                                vertices)
        .convert(execution_, std::move(flat), function, graph);
    statistics_.seconds_of_finishing += seconds_since(began);
    return statistics_;
  }

  Execution execution_;
  const NamedParameters& np_;
  decltype(CGAL::get_initialized_vertex_index_map(
      std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>())) vertex_index_;
  Clock::time_point began_ = Clock::now();
  Prepared_surface<TriangleMesh, Vertex_point_map> surface_;
  Geom_traits traits_;
  Reeb_options options_;
  Reeb_statistics statistics_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_COMPUTATION_H
