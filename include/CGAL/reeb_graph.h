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
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
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

computes the Reeb graph of a diffusion on a surface; `CGAL::reeb_graph_of_function()` does that of
any function on its vertices.

The Reeb graph of a function has a point for each contour, that is, for each connected component of
a level set. Its nodes are the critical points, where contours begin, meet, part and end; its arcs
are what the contours between them sweep. It is computed exactly: a function stands for the order of
its values, with ties broken by the indices of the vertices, and a saddle at which more than two
contours meet is unfolded into simple ones. Thus, before and after the simplification, whatever the
function is: the graph has one component for each component of the surface, the graph of a closed
connected surface of genus g has g independent cycles, there are 2 - 2g more minima and maxima than
saddles, and each vertex of the mesh belongs to one arc.

The function is the arrival time of a front (\cgalCite{weinrauch2023variational}, section
6): on components with handles it starts at both sides of all handle loops, which puts the junctions
where the handles branch off; on components of genus 0 it starts at one vertex, the one that a first
front from the vertex of smallest index reaches last. Each arc is drawn along the means of the
contours. Means that are outside of the solid, where contours are not convex, are drawn at the
center of a ball that touches the contour from inside, and lines are rounded off as far as that does
not take them outside. Most of the line is inside then, not all of it; `embed_reeb_graph()` draws
all of it inside, in more time.

Leaves that are small, the smallest first, are taken off together with the saddle that they end at.
An arc that has become one with another by this may pass a cancelled extremum. A leaf stays where
without it the component would have no node with three arcs. Arcs that are shorter than thick can be
contracted (`Reeb_options::shortest_arc`), so that each stands for a part that one would name.

The time for a given function is linear but for sorting the vertices, plus the length of the shorter
contour at each saddle where one parts; if these add up to more than eight times the number of
halfedges it is \f$ O(n \log n) \f$ from there on. The memory is about 80 bytes per face, and
100 to 180 where a third of the vertices are critical points.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag`,
  `Cuda_if_available_tag` and `Reference_tag`. With the CUDA tags all fields, those that find the
  handle loops and the diffusion itself, run on the device, and the rest on the processor, in
  parallel if TBB is linked. With `Reference_tag` all fields are those of the reference solver, in
  one thread. The result does not depend on the tag, but for `Reference_tag`, which finds handle
  loops and arrival times of its own.
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
  \cgalParamNBegin{reeb_options}
    \cgalParamDescription{what the graph is to be like}
    \cgalParamType{`Handle_tunnel_loops::Reeb_options`}
    \cgalParamDefault{as that says}
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
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{how the fields are computed: of the options, the constants of the field,
the device, whether to use a coarse mesh, and the literal rules are looked at, of which those of the
Laplacian and of its coefficient are followed in the diffusion, too}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{as that says}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what the computation did

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws Handle_tunnel_loops::Literal_failure_exception if a literal rule leads nowhere
\throws Handle_tunnel_loops::Device_exception if a CUDA device was asked for, see `Cuda_tag`
\throws std::invalid_argument if a source is not a vertex with faces, or the threshold is not in [0,
1]

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
    impl::Pass_options options;
    options.field_constants = given.field_constants;
    options.literal_rules = given.literal_rules;
    options.device = given.device;
    options.do_coarsen = given.do_coarsen;
    options.do_tighten = false; // a front forgets where exactly it started
    const auto nothing = [](Stage) {};
    impl::Progress progress(
        choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()),
        nothing, nothing, statistics, impl::Progress::stages_of_diffusion());
    const auto passes = impl::make_passes<ConcurrencyTag>(mesh, mesh.seeds, options);
    return impl::diffusion_times(*passes, options, mesh, computation.sources(), progress,
                                 statistics);
  };
  return computation.run_on_times(diffusion, graph);
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_H
