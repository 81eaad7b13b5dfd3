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

#include <CGAL/Handle_tunnel_loops/Device_options.h>
#include <CGAL/Handle_tunnel_loops/Field_constants.h>
#include <CGAL/Handle_tunnel_loops/Literal_rules.h>
#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/check_constants.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Passes_of_tag.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/diffusion_times.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_computation.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>
#include <CGAL/reeb_graph_of_function.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <functional>

/// \file reeb_graph.h
/// The Reeb graph of a diffusion, or of any function on the vertices.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

computes the Reeb graph of a diffusion on a surface, or that of any function on its vertices.

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
contours. Means that are outside of the solid, where contours are not convex, are drawn at the
center of a ball that touches the contour from inside, and lines are rounded off as far as that does
not take them outside. Most of the line is inside then, not all of it.

Leaves that are small, the smallest first, are taken off together with the saddle that they end at.
An arc that has become one with another by this may pass a cancelled extremum. A leaf stays where
without it the component would have no node with three arcs.

The time for a given function is linear but for sorting the vertices, plus the length of the shorter
contour at each saddle where one parts; if these add up to more than eight times the number of
halfedges it is \f$ O(n \log n) \f$ from there on. The memory is about 80 bytes per face, and
100 to 180 where a third of the vertices are critical points.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, and `Parallel_if_available_tag`; for a diffusion
  also `Cuda_tag`, `Cuda_if_available_tag` and `Reference_tag`. With the CUDA tags all fields, those
  that find the handle loops and the diffusion itself, run on the device, and the rest on the
  processor, in parallel if TBB is linked. With `Reference_tag` all fields are those of the
  reference solver, in one thread. The result does not depend on the tag, but for `Reference_tag`,
  which finds handle loops and arrival times of its own. With `vertex_function_map`, and in
  `CGAL::reeb_graph_of_function()`, there is no field, and only the first three tags compile.
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
  \cgalParamNBegin{vertex_value_map}
    \cgalParamDescription{is given, for each vertex that is not isolated, the value of the function:
      of a diffusion, its arrival time in steps}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `double` as values}
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
  \cgalParamNBegin{device_options}
    \cgalParamDescription{the device and the stream to use with `Cuda_tag` and
      `Cuda_if_available_tag`}
    \cgalParamType{`Handle_tunnel_loops::Device_options`}
    \cgalParamDefault{the current device, and a stream of its own}
  \cgalParamNEnd
  \cgalParamNBegin{field_constants}
    \cgalParamDescription{the constants of the phase field}
    \cgalParamType{`Handle_tunnel_loops::Field_constants`}
    \cgalParamDefault{those of the paper}
  \cgalParamNEnd
  \cgalParamNBegin{literal_rules}
    \cgalParamDescription{which rules of the paper `Reference_tag` is to follow to the letter, for
the handle loops and, those of the Laplacian and of its coefficient, for the diffusion}
    \cgalParamType{`Handle_tunnel_loops::Literal_rules`}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what the computation did

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates
\throws Handle_tunnel_loops::Invalid_function_exception if the function is infinite or not a number
  at a vertex
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws Handle_tunnel_loops::Literal_failure_exception if a rule among `literal_rules` leads nowhere
\throws Handle_tunnel_loops::Device_exception if a CUDA device was asked for, see `Cuda_tag`
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
  using namespace Handle_tunnel_loops;
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if constexpr(parameters::is_default_parameter<NamedParameters,
                                                internal_np::vertex_function_map_t>::value)
  {
    const auto device_options =
        choose_parameter(get_parameter(np, internal_np::device_options), Device_options());
    auto computation = [&] {
      const typename impl::Passes_of_tag<ConcurrencyTag>::Head_start head_start(device_options,
                                                                                num_vertices(tm));
      return impl::Reeb_computation<TriangleMesh, NamedParameters>(
          impl::execution_of<ConcurrencyTag>(), tm, np);
    }();
    const auto diffusion = [&](const impl::Flat_mesh& mesh, Statistics& statistics) {
      impl::Pass_options options;
      options.constants =
          choose_parameter(get_parameter(np, internal_np::field_constants), Field_constants());
      impl::check_constants(options.constants);
      options.literal_rules =
          choose_parameter(get_parameter(np, internal_np::literal_rules), Literal_rules());
      options.do_tighten = false; // a front forgets where exactly it started
      const auto nothing = [](Stage) {};
      impl::Progress progress(
          choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
          nothing, nothing, statistics, impl::Progress::stages_of_diffusion());
      const auto passes =
          impl::Passes_of_tag<ConcurrencyTag>::make(mesh, mesh.seeds, options, device_options);
      return impl::diffusion_times(*passes, options, mesh, computation.sources(), progress,
                                   statistics);
    };
    return computation.run_on_times(diffusion, graph);
  } else {
    return reeb_graph_of_function<ConcurrencyTag>(
        tm, get_parameter(np, internal_np::vertex_function_map), graph, np);
  }
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_H
