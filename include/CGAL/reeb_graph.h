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

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/diffusion.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_computation.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>
#include <CGAL/reeb_graph_of_function.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <functional>

/// \file reeb_graph.h
/// Computes the Reeb graph of a diffusion.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes the Reeb graph of a diffusion on a surface. For any other function on the vertices, use
`CGAL::reeb_graph_of_function()`.

The Reeb graph of a function has one point for each contour, that is, for each connected component
of a level set. Its nodes are the critical points, where contours begin, merge, split and end. Its
arcs represent the contours between them. The graph is computed exactly: only the order of the
function values matters, with ties broken by the indices of the vertices, and a saddle at which more
than two contours merge is split into simple saddles. For any function, the following therefore
holds before and after the simplification. The graph has one connected component for each component
of the surface. If it has c independent cycles, the number of minima and maxima minus the number of
saddles is 2 - 2c. For a closed connected surface of genus g, c is g. For one with b > 0 boundary
curves, c is at least g and at most 2g + b - 1. Each vertex of the mesh belongs to one arc.

Contours end at the boundary. Where two contours that both do so meet in a saddle, they exchange
their ends: the graph has two saddles at the same vertex, joined by an arc without vertices. If
`Reeb_options::capped` is set, boundary curves are closed by caps first, and c is g.

The function is the arrival time of a front (\cgalCite{weinrauch2023variational}, section 6). On
components with handles, the front starts at both sides of all handle loops, which places the joints
where the handles branch off. On components of genus 0, it starts at one vertex, which is the last
vertex that another front reaches from the vertex of smallest index. Each arc is drawn along the
centroids of the contours. If contours are not convex and a centroid lies outside the solid, the
center of a ball that touches the contour from inside is used instead. The polylines are smoothed as
far as this does not move them outside. They lie mostly, but not entirely, inside;
`embed_reeb_graph()` computes polylines that lie inside entirely, in more time.

The simplification removes small leaves together with the saddles at which they end, the smallest
leaf first. An arc that is merged with another arc in this process may pass a canceled extremum. A
leaf is kept if the component would have no node with three arcs without it. Arcs that are shorter
than thick can be contracted (`Reeb_options::shortest_arc`), so that each remaining arc represents a
recognizable part of the surface.

The running time for given function values is linear, except for sorting the vertices, plus the
length of the shorter contour at each saddle where a contour splits. If these lengths add up to more
than eight times the number of halfedges, the rest of the sweep takes \f$ O(n \log n) \f$, as does
the whole sweep if contours end at a boundary. The memory is about 80 bytes per face, and 100 to 180
bytes per face if a third of the vertices are critical points.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag`,
  `Cuda_if_available_tag` and `Reference_tag`. With the CUDA tags, all fields (those that find the
  handle loops and the diffusion itself) run on the device; the other steps run on the processor, in
  parallel if TBB is linked. With `Reference_tag`, the reference solver computes all fields in one
  thread. The result does not depend on the tag, except for `Reference_tag`, which computes
  different handle loops and arrival times.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph `Reeb_graph<TriangleMesh, Point>`, where `Point` is the value type of the vertex point
  map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param graph the graph that receives the result; its previous content is replaced. It has no
  parallel edges and no self-loops, unless `Reeb_options::allow_parallel_arcs` is set, so you can
  pass it to `CGAL::split_graph_into_polylines()`. Nodes of type `Reeb_node_type::REGULAR` are added
  where needed for this.
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{seed_vertex}
    \cgalParamDescription{the vertex at which the diffusion starts, in the component of that vertex}
    \cgalParamType{`boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{the handle loops, or one vertex on components of genus 0, as described above}
  \cgalParamNEnd
  \cgalParamNBegin{source_vertices}
    \cgalParamDescription{the vertices at which the diffusion starts, in the components of these
      vertices}
    \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{the handle loops, or one vertex on components of genus 0, as described above}
    \cgalParamExtra{Components without a source are treated as those of genus 0.}
  \cgalParamNEnd
  \cgalParamNBegin{reeb_options}
    \cgalParamDescription{the options of the graph}
    \cgalParamType{`Handle_tunnel_loops::Reeb_options`}
    \cgalParamDefault{a default-constructed object}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_arc_map}
    \cgalParamDescription{receives, for each vertex that is not isolated, the index of its arc}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `std::size_t` as value type}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_value_map}
    \cgalParamDescription{receives, for each vertex that is not isolated, the value of the function.
      For a diffusion, this is the arrival time in steps}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `double` as value type}
    \cgalParamDefault{unused}
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
    \cgalParamDescription{a function that is called with the progress of the diffusion, from 0 to 1,
      and returns `false` to stop the computation}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
    \cgalParamExtra{After a stop, the graph is unchanged.}
  \cgalParamNEnd
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{the options of the computation of the fields. Only the constants of the
      field, the device, `do_coarsen` and the literal rules are used. The diffusion follows only the
      literal rules of the Laplacian and its coefficient}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{a default-constructed object}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the statistics of the computation

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates
\throws Handle_tunnel_loops::Interrupted_exception if the callback returned `false`
\throws Handle_tunnel_loops::Literal_failure_exception if a rule of literal mode finds no result
\throws Handle_tunnel_loops::Device_exception if `Cuda_tag` was used and the CUDA device failed or
  is missing
\throws std::invalid_argument if a source is not a vertex with faces, or if the threshold is not in
  [0, 1]

\sa `CGAL::handle_tunnel_loops()`
\sa `CGAL::embed_reeb_graph()`
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
  using namespace Handle_tunnel_loops;
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto given =
      choose_parameter(get_parameter(np, internal_np::solver_options), Solver_options());
  auto computation = [&] {
    const auto head_start = impl::head_start<ConcurrencyTag>(given, num_vertices(tm));
    return impl::Reeb_computation<TriangleMesh, NamedParameters>(
        impl::execution_of<ConcurrencyTag>(), tm, np);
  }();
  const auto diffusion = [&](const impl::Flat_mesh& mesh, Statistics& statistics) {
    return impl::times_of_diffusion(
        mesh, &impl::make_passes<ConcurrencyTag>, given, computation.sources(),
        choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
        statistics);
  };
  return computation.run_on_times(diffusion, impl::ticks_per_step_of_diffusion(), graph);
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_H
