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
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_finishing.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the vertex of a boundary curve that is in the middle of these, in the order of a function. A hub
/// with the same key is no critical point, unless the function has several maxima on the curve.
template <typename Key> Index middle_of_curve(const Flat_mesh& mesh, Index hub, const Key& key) {
  std::vector<Index> curve(mesh.ring(hub).begin(), mesh.ring(hub).end());
  const auto middle = curve.begin() + static_cast<std::ptrdiff_t>(curve.size() / 2);
  std::nth_element(curve.begin(), middle, curve.end(), [&](Index u, Index v) {
    return key(u) != key(v) ? key(u) < key(v) : mesh.original[u] < mesh.original[v];
  });
  return *middle;
}

/// A function of the caller, as numbers to calculate with and as integers to sort by. Integers are
/// sorted exactly, all else as double. On a cap it leads from side to side, without a peak.
class Function_on_vertices
{
public:
  /// \p vertices are those of the flat mesh but for the hubs. Throws `Invalid_function_exception`.
  template <typename Map, typename Vertices>
  Function_on_vertices(const Flat_mesh& mesh, const Map& map, const Vertices& vertices) {
    using Scalar = std::decay_t<typename boost::property_traits<Map>::value_type>;
    values_.reserve(vertices.size());
    keys_.reserve(vertices.size());
    Index not_finite = no_index;
    for(std::size_t v = 0; v < vertices.size(); ++v) {
      const Scalar scalar = get(map, vertices[v]);
      if constexpr(std::is_arithmetic<Scalar>::value)
        values_.push_back(static_cast<double>(scalar));
      else
        values_.push_back(CGAL::to_double(scalar));
      if(!std::isfinite(values_.back()))
        not_finite = (std::min)(not_finite, mesh.original[v]);
      if constexpr(std::is_integral<Scalar>::value)
        keys_.push_back(ordering_key(scalar));
      else
        keys_.push_back(ordering_key(values_.back()));
    }
    if(not_finite != no_index)
      throw Invalid_function_exception(not_finite);
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub) {
      const Index v = middle_of_curve(mesh, hub, [this](Index u) { return keys_[u]; });
      values_.push_back(values_[v]);
      keys_.push_back(keys_[v]);
    }
  }

  double value(Index v) const { return values_[v]; }
  std::uint64_t key(Index v) const { return keys_[v]; }

private:
  std::vector<double> values_;
  std::vector<std::uint64_t> keys_;
};

/// Sweeps a function and finishes its Reeb graph. `Key` gives the integers that order the vertices,
/// `Value` the values that they stand for.
template <typename Key, typename Value>
Embedded_reeb_graph find_reeb_graph(Execution execution,
                                    const Flat_mesh& mesh,
                                    const Key& key,
                                    const Value& value,
                                    Reeb_measure default_measure,
                                    const Reeb_options& options,
                                    Reeb_statistics& statistics) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const Sweep_order order(execution, mesh, key, options.capped);
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
      Reeb_finishing<Value>(execution, mesh, order, graph, value)
          .run(options.measure.value_or(default_measure), options.threshold, options.shortest_arc);
  statistics.seconds_of_finishing = std::chrono::duration<double>(Clock::now() - has_swept).count();
  return result;
}

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
    if(!(options_.threshold >= 0. && options_.threshold <= 1.))
      throw std::invalid_argument("the threshold of the simplification must be in [0, 1]");
    if(!(options_.shortest_arc >= 0.))
      throw std::invalid_argument("the length of the shortest arc must not be negative");
    surface_.describe(statistics_);
    statistics_.seconds_of_adaptor = seconds_since(began_);
  }

  /// the vertices at which the parameters want a diffusion to start, if they say so.
  std::vector<Index> sources() const {
    std::vector<vertex_descriptor> given;
    if constexpr(is_given<internal_np::seed_vertex_t>)
      given.push_back(parameters::get_parameter(np_, internal_np::seed_vertex));
    if constexpr(is_given<internal_np::source_vertices_t>)
      for(vertex_descriptor v : parameters::get_parameter(np_, internal_np::source_vertices))
        given.push_back(v);
    if(given.empty())
      return {};
    std::vector<Index> flat_index;
    for(Index i = 0; i < mesh_.first_hub; ++i) {
      flat_index.resize((std::max)(flat_index.size(), std::size_t(mesh_.original[i]) + 1),
                        no_index);
      flat_index[mesh_.original[i]] = static_cast<Index>(i);
    }
    std::vector<Index> sources;
    for(vertex_descriptor v : given) {
      const std::size_t i = get(vertex_index_, v);
      if(i >= flat_index.size() || flat_index[i] == no_index)
        throw std::invalid_argument("a source vertex is isolated or not in the mesh");
      sources.push_back(flat_index[i]);
    }
    return sources;
  }

  /// the graph of a function of the caller.
  template <typename Map, typename Graph>
  Reeb_statistics run_on_function(const Map& map, Graph& graph) {
    const auto began = Clock::now();
    const Function_on_vertices function(mesh_, map, vertices_);
    statistics_.seconds_of_function = seconds_since(began);
    return find(function, graph);
  }

  /// the graph of the arrival times that `find_times()` returns, given the mesh and a record of
  /// what it does.
  template <typename FindTimes, typename Graph>
  Reeb_statistics run_on_times(const FindTimes& find_times, Graph& graph) {
    const auto began = Clock::now();
    Statistics statistics;
    std::vector<Time> times = find_times(mesh_, statistics);
    // As of any function: what the front does in a cap is no matter of the surface.
    for(Index hub = mesh_.first_hub; hub < mesh_.number_of_vertices(); ++hub)
      times[hub] = times[middle_of_curve(mesh_, hub, [&](Index u) { return times[u]; })];
    statistics_.backend = statistics.backend;
    statistics_.fallback = statistics.fallback;
    statistics_.seconds_of_function = seconds_since(began);
    return find([&](Index v) { return std::uint64_t(times[v]); },
                [&](Index v) { return double(times[v]) / ticks_per_step; }, Reeb_measure::LIMBS,
                graph);
  }

private:
  static double seconds_since(Clock::time_point began) {
    return std::chrono::duration<double>(Clock::now() - began).count();
  }

  // Once for all types of maps.
  template <typename Graph>
  Reeb_statistics find(const Function_on_vertices& function, Graph& graph) {
    return find([&](Index v) { return function.key(v); },
                [&](Index v) { return function.value(v); }, Reeb_measure::PERSISTENCE, graph);
  }

  template <typename Key, typename Value, typename Graph>
  Reeb_statistics
  find(const Key& key, const Value& value, Reeb_measure default_measure, Graph& graph) {
    Embedded_reeb_graph flat =
        find_reeb_graph(execution_, mesh_, key, value, default_measure, options_, statistics_);
    const auto began = Clock::now();
    name_hubs(key);
    if(!options_.allow_parallel_arcs)
      make_simple(flat);
    leave_out_hubs(flat);
    if constexpr(is_given<internal_np::vertex_arc_map_t>) {
      const auto map = parameters::get_parameter(np_, internal_np::vertex_arc_map);
      for(std::size_t a = 0; a < flat.arcs.size(); ++a)
        for(Index v : flat.arcs[a].vertices)
          put(map, vertices_[v], a);
    }
    if constexpr(is_given<internal_np::vertex_value_map_t>) {
      const auto map = parameters::get_parameter(np_, internal_np::vertex_value_map);
      for(Index v = 0; v < mesh_.first_hub; ++v)
        put(map, vertices_[v], value(v));
    }
    Reeb_converter<TriangleMesh, Vertex_point_map, Geom_traits>(surface_.point, traits_, mesh_,
                                                                vertices_)
        .convert(execution_, std::move(flat), value, graph);
    statistics_.seconds_of_finishing += seconds_since(began);
    return statistics_;
  }

  // What is at a hub is said to be at a vertex on its curve.
  template <typename Key> void name_hubs(const Key& key) {
    vertices_.resize(mesh_.first_hub);
    for(Index hub = mesh_.first_hub; hub < mesh_.number_of_vertices(); ++hub)
      vertices_.push_back(vertices_[middle_of_curve(mesh_, hub, key)]);
  }

  void leave_out_hubs(Embedded_reeb_graph& flat) const {
    if(mesh_.number_of_hubs > 0)
      for(Embedded_reeb_graph::Arc& arc : flat.arcs)
        arc.vertices.erase(std::remove_if(arc.vertices.begin(), arc.vertices.end(),
                                          [this](Index v) { return mesh_.is_hub(v); }),
                           arc.vertices.end());
  }

  Execution execution_;
  const NamedParameters& np_;
  decltype(CGAL::get_initialized_vertex_index_map(
      std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>())) vertex_index_;
  Clock::time_point began_ = Clock::now();
  Prepared_surface<TriangleMesh, Vertex_point_map> surface_;
  const Flat_mesh& mesh_ = surface_.mesh;
  std::vector<vertex_descriptor>& vertices_ = surface_.vertices;
  Geom_traits traits_;
  Reeb_options options_;
  Reeb_statistics statistics_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_COMPUTATION_H
