// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_REEB_GRAPH_H
#define CGAL_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Field_constants.h>
#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/check_constants.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Function_on_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_graph_finder.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

/// \file reeb_graph.h
/// The Reeb graph of a diffusion, or of any function on the vertices.

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// One computation of a Reeb graph, for one set of named parameters.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
class Reeb_computation
{
  using Execution = decltype(execution<ConcurrencyTag>());
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Clock = std::chrono::steady_clock;

  template <typename Tag>
  static constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

public:
  Reeb_computation(const TriangleMesh& tm, const NamedParameters& np)
      : np_(np)
      , vertex_index_(CGAL::get_initialized_vertex_index_map(tm, np))
      , point_(
            parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                         get_const_property_map(vertex_point, tm)))
      , traits_(parameters::choose_parameter<Geom_traits>(
            parameters::get_parameter(np, internal_np::geom_traits)))
      , threshold_(parameters::choose_parameter(
            parameters::get_parameter(np, internal_np::simplification_threshold),
            default_simplification_threshold)) {
    if(!(threshold_ >= 0. && threshold_ <= 1.))
      throw std::invalid_argument("the threshold of the simplification must be in [0, 1]");
    const auto began = Clock::now();
    Flat_mesh_builder<TriangleMesh, std::decay_t<decltype(vertex_index_)>, Vertex_point_map,
                      Execution>
        builder(tm, vertex_index_, point_);
    mesh_ = builder.build();
    vertices_ = builder.take_vertices();
    statistics_.number_of_vertices = mesh_.number_of_vertices();
    statistics_.number_of_faces = mesh_.number_of_faces();
    statistics_.number_of_components = mesh_.seeds.size();
    statistics_.genus = mesh_.genus;
    statistics_.seconds_of_adaptor = seconds_since(began);
  }

  template <typename Graph> Reeb_statistics run(Graph& graph) {
    const auto began = Clock::now();
    if constexpr(is_given<internal_np::vertex_function_map_t>) {
      const Function_on_vertices function(
          mesh_, parameters::get_parameter(np_, internal_np::vertex_function_map), vertices_);
      statistics_.seconds_of_function = seconds_since(began);
      find([&](Index v) { return function.key(v); }, [&](Index v) { return function.value(v); },
           graph);
    } else {
      const std::vector<Time> times = diffusion();
      statistics_.seconds_of_function = seconds_since(began);
      find([&](Index v) { return std::uint64_t(times[v]); },
           [&](Index v) { return double(times[v]) / ticks_per_step; }, graph);
    }
    return statistics_;
  }

private:
  static double seconds_since(Clock::time_point began) {
    return std::chrono::duration<double>(Clock::now() - began).count();
  }

  std::vector<Time> diffusion() {
    const auto callback = parameters::choose_parameter(
        parameters::get_parameter(np_, internal_np::callback), std::function<bool(double)>());
    const auto constants = parameters::choose_parameter(
        parameters::get_parameter(np_, internal_np::field_constants), Field_constants());
    check_constants(constants);
    Statistics ignored;
    Progress progress(
        callback, [](Stage) {}, [](Stage) {}, ignored);
    return diffusion_times<ConcurrencyTag>(mesh_, sources(), constants, progress);
  }

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
    for(std::size_t i = 0; i < vertices_.size(); ++i) {
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

  template <typename Key, typename Value, typename Graph>
  void find(const Key& key, const Value& value, Graph& graph) {
    const auto measure = parameters::choose_parameter(
        parameters::get_parameter(np_, internal_np::reeb_measure),
        is_given<internal_np::vertex_function_map_t> ? Reeb_measure::PERSISTENCE
                                                     : Reeb_measure::LIMBS);
    const bool allows_parallel_arcs = parameters::choose_parameter(
        parameters::get_parameter(np_, internal_np::allow_parallel_arcs), false);
    Embedded_reeb_graph flat =
        find_reeb_graph<Execution>(mesh_, key, value, measure, threshold_, statistics_);
    const auto began = Clock::now();
    if(!allows_parallel_arcs)
      make_simple(flat);
    if constexpr(is_given<internal_np::vertex_arc_map_t>) {
      const auto map = parameters::get_parameter(np_, internal_np::vertex_arc_map);
      for(std::size_t a = 0; a < flat.arcs.size(); ++a)
        for(Index v : flat.arcs[a].vertices)
          put(map, vertices_[v], a);
    }
    Reeb_converter<TriangleMesh, Vertex_point_map, Geom_traits>(point_, traits_, mesh_, vertices_)
        .convert(Execution(), std::move(flat), value, graph);
    statistics_.seconds_of_finishing += seconds_since(began);
  }

  const NamedParameters& np_;
  decltype(CGAL::get_initialized_vertex_index_map(
      std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>())) vertex_index_;
  Vertex_point_map point_;
  Geom_traits traits_;
  double threshold_;
  Flat_mesh mesh_;
  std::vector<vertex_descriptor> vertices_; // by index of the flat mesh
  Reeb_statistics statistics_;
};

} // namespace internal
} // namespace Handle_tunnel_loops

/*!
\ingroup PkgHandleTunnelLoopsRef

computes the Reeb graph of a diffusion on a closed surface, or that of any function on its vertices.

The Reeb graph of a function has a point for each contour, that is, for each connected component of
a level set. Its nodes are the critical points, where contours begin, meet, part and end; its arcs
are what the contours between them sweep. It is computed exactly: a function stands for the order of
its values, with ties broken by the indices of the vertices, and a saddle at which more than two
contours meet is unfolded into simple ones. Thus, before and after the simplification, whatever the
function is: the graph has one component for each component of the surface, the graph of a closed
connected surface of genus g has g independent cycles, there are 2 - 2g more minima and maxima than
saddles, and each vertex of the mesh belongs to one arc.

By default the function is the arrival time of a front (\cgalCite{weinrauch2023variational}, section
6): on components with handles it starts at both sides of all handle loops, which puts the junctions
where the handles branch off; on components of genus 0 it starts at one vertex, the one that a first
front from the vertex of smallest index reaches last. Each arc is drawn along the means of the
contours, so that the graph lies inside where the surface is tubular.

Leaves that are small, the smallest first, are taken off together with the saddle that they end at.
An arc that has become one with another by this may pass a cancelled extremum. A leaf stays where
without it the component would have no node with three arcs.

The time for a given function is linear but for sorting the vertices, plus the length of the shorter
contour at each saddle where one parts; if these add up to more than eight times the number of
halfedges it is \f$ O(n \log n) \f$ from there on. The memory is about 80 bytes per face, and
100 to 180 where a third of the vertices are critical points.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, and `Parallel_if_available_tag`. The result does
  not depend on it.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph a `Reeb_graph<TriangleMesh, Point>`, where `Point` is the value type of the vertex
  point map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param graph the graph that the result is assigned to. It has no parallel edges and no loops, so
that it is fit for `CGAL::split_graph_into_polylines()`; this takes some nodes of type
  `Reeb_node_type::REGULAR`.
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_function_map}
    \cgalParamDescription{the function; equal values are ordered by the indices of their vertices}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
      numbers that `CGAL::to_double()` takes as values; they are compared as `double`, integers as
      they are}
    \cgalParamDefault{the arrival time of a diffusion}
  \cgalParamNEnd
  \cgalParamNBegin{seed_vertex}
    \cgalParamDescription{the vertex at which the diffusion starts, in its component}
    \cgalParamType{`boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{see above}
  \cgalParamNEnd
  \cgalParamNBegin{source_vertices}
    \cgalParamDescription{the vertices at which the diffusion starts, in their components}
    \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{see above}
    \cgalParamExtra{Components without a source are treated as those of genus 0.}
  \cgalParamNEnd
  \cgalParamNBegin{simplification_threshold}
    \cgalParamDescription{leaves are taken off whose size is at most this part of the whole, in the
measure given by `reeb_measure`}
    \cgalParamType{`double`, in [0, 1]}
    \cgalParamDefault{0.03}
    \cgalParamExtra{0 gives the full Reeb graph.}
  \cgalParamNEnd
  \cgalParamNBegin{reeb_measure}
    \cgalParamDescription{how the size of a leaf is measured}
    \cgalParamType{`Reeb_measure`}
    \cgalParamDefault{`Reeb_measure::LIMBS` for a diffusion, `Reeb_measure::PERSISTENCE` for a given
function}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{is given, for each vertex that is not isolated, the index of its arc}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
`std::size_t` as value type}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{allow_parallel_arcs}
    \cgalParamDescription{whether several arcs may join the same two nodes, or one a node to itself;
if so there are no regular nodes}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is told the progress of a diffusion, from 0 to 1, and asks to stop by
returning `false`}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
    \cgalParamExtra{After a stop the graph is as it was.}
  \cgalParamNEnd
  \cgalParamNBegin{field_constants}
    \cgalParamDescription{the constants of the phase field}
    \cgalParamType{`Handle_tunnel_loops::Field_constants`}
    \cgalParamDefault{those of the paper}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what the computation did

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not a closed, oriented 2-manifold
  triangle mesh with finite coordinates
\throws Handle_tunnel_loops::Invalid_function_exception if the function is infinite or not a number
  at a vertex
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws std::invalid_argument if a source is not a vertex with faces, or the threshold is not in [0,
1]

\sa `CGAL::handle_tunnel_loops()`
\sa `CGAL::split_graph_into_polylines()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Graph,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Reeb_statistics
reeb_graph(const TriangleMesh& tm,
           Graph& graph,
           const NamedParameters& np = parameters::default_values()) {
  return Handle_tunnel_loops::internal::Reeb_computation<ConcurrencyTag, TriangleMesh,
                                                         NamedParameters>(tm, np)
      .run(graph);
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_H
