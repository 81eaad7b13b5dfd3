// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_CUT_TO_DISK_H
#define CGAL_CUT_TO_DISK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_request.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/cut_open.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/for_each_loop_of.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <iterator>
#include <type_traits>
#include <vector>

/// \file cut_to_disk.h
/// Computes cuts that open surfaces to disks.

namespace CGAL {

namespace Handle_tunnel_loops::internal {

/// Passes the named parameters about edges and vertices to a request.
template <typename Request, typename NamedParameters>
void read_parameters(Request& request, const NamedParameters& np) {
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  if constexpr(is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value)
    request.use_lengths();
  else
    request.use_weights(get_parameter(np, internal_np::edge_weight));
  if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value)
    request.keep_edges(get_parameter(np, internal_np::edge_is_constrained));
  if constexpr(!is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value)
    request.add_cones(get_parameter(np, internal_np::vertex_is_constrained));
  request.cut_spheres(choose_parameter(get_parameter(np, internal_np::do_cut_spheres), false));
  request.open_at_boundaries();
}

} // namespace Handle_tunnel_loops::internal

/*!
\ingroup PkgHandleTunnelLoopsRef

Finds edges that cut a surface to disks. After cutting along them, every connected component that
has positive genus or several boundary curves is one disk. The cut starts from the loops of the
shortest basis that `handle_tunnel_loops()` finds: they are moved onto the edges and connected by
shortest arcs, with the preferences of \cgalCite{erickson2005greedy} for a spanning tree of the dual
graph. Then each arc of the cut is replaced by the shortest path that can take its place, until no
replacement is shorter. The cut is short, but not necessarily shortest. Before anything is written,
the function certifies by counting that each component is a disk: its Euler characteristic is 1 and
it has one boundary cycle.

Closed components of genus 0 are not cut, unless they have cones or constrained edges, or
`do_cut_spheres` is set. Components that are already disks are not cut either.

The running time is that of finding the loops, plus about that of two runs of Dijkstra's algorithm
for each round of replacements, for any number of arcs.

The result does not depend on the number of threads.

\tparam ConcurrencyTag enables sequential versus parallel computation of the loops, with the
  possible values of `handle_tunnel_loops()`; the default is `Sequential_tag`
\tparam TriangleMesh a model of `FaceListGraph` and `EdgeListGraph`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `boost::graph_traits<TriangleMesh>::%edge_descriptor`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param out the output iterator that receives the edges, each edge once
\param np an optional sequence of named parameters among those listed below and those of
  `handle_tunnel_loops()`

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{vertices that the cut must pass through, so that they lie on the boundary
      of the disk, for example the cones of a parametrization}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{none}
    \cgalParamExtra{A sphere with one such vertex is cut from this vertex to the farthest vertex.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{a non-negative weight for each edge, used instead of its length. An edge
      of infinite weight is never part of the cut}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a number as value type}
    \cgalParamDefault{the length of the edge}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{edges that must be part of the cut}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{known_loops}
    \cgalParamDescription{loops to start from, which replaces their computation. Any loops are
      valid; a basis of short loops gives the best result}
    \cgalParamType{a range of `Handle_tunnel_pair<TriangleMesh>` or `Loop_on_surface<TriangleMesh>`}
    \cgalParamDefault{the loops of the shortest basis are computed}
  \cgalParamNEnd
  \cgalParamNBegin{do_cut_spheres}
    \cgalParamDescription{whether closed components of genus 0 are cut as well, along an arc between
      vertices that are far apart}
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
\cgalNamedParamsEnd

\return `out`, past the last edge written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh, with or without boundary, with finite coordinates
\throws Handle_tunnel_loops::No_cut_exception if no cut satisfies the constraints and the infinite
  weights; the message names the cause. This is decided before loops are computed
\throws std::invalid_argument if a constrained vertex has no face, or if a weight is negative or not
  a number
\throws Handle_tunnel_loops::Uncertified_cut_exception if the result fails its certificate. This
  indicates a defect of the package; nothing has been written
\throws . the exceptions of `handle_tunnel_loops()`

\sa `add_seams_of_cut()`
\sa `mark_loop_edges()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator cut_to_disk(const TriangleMesh& tm,
                           OutputIterator out,
                           const NamedParameters& np = parameters::default_values()) {
  using namespace Handle_tunnel_loops;
  namespace impl = Handle_tunnel_loops::internal;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Solver = Handle_tunnel_loops_solver<TriangleMesh, Vertex_point_map, Geom_traits>;
  Solver solver(ConcurrencyTag(), tm, np);
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  impl::Cut_request request(impl::execution_of<ConcurrencyTag>(), vertex_index,
                            solver.prepared_surface());
  impl::read_parameters(request, np);
  impl::check_rules(request.problem());
  const auto add = [&](const auto& loop) { request.add_loop(loop); };
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::known_loops_t>::value)
  {
    std::vector<typename Solver::Pair> pairs;
    auto options = parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::solver_options), Solver_options());
    options.do_compute_linking = false;
    solver.template find_loops<ConcurrencyTag>(
        std::back_inserter(pairs),
        parameters::solver_options(options, parameters::basis_kind(Basis_kind::SHORTEST, np)));
    for(const auto& pair : pairs)
      impl::for_each_loop_of(pair, add);
  } else {
    for(const auto& item : parameters::get_parameter(np, internal_np::known_loops))
      impl::for_each_loop_of(item, add);
  }
  for(const impl::Index h : impl::cut_open(request.problem()))
    if(!request.problem().is_spoke(h))
      *out++ = edge(request.halfedge_of_caller(h), tm);
  return out;
}

/*!
\ingroup PkgHandleTunnelLoopsRef

Adds the edges of a cut to the seams of a `Seam_mesh`. Each edge is added with
`Seam_mesh::add_seam()`, so the property maps and counters of the seam mesh stay consistent. Call
this function before you query the number of vertices of the seam mesh, because the seam mesh caches
this number.

\tparam SeamMesh an instance of `Seam_mesh`
\tparam EdgeRange a range of edges of the underlying mesh

\param seam_mesh the seam mesh; its property maps must not mark these edges as seams yet
\param edges the edges, for example those that `cut_to_disk()` writes

\return a halfedge of the underlying mesh on the first edge that was added, as
  `Seam_mesh::add_seams()` returns it, or the null halfedge if no edge was added
*/
template <typename SeamMesh, typename EdgeRange>
auto add_seams_of_cut(SeamMesh& seam_mesh, const EdgeRange& edges) {
  const auto& tm = seam_mesh.mesh();
  using Graph_traits = boost::graph_traits<std::decay_t<decltype(tm)>>;
  typename Graph_traits::halfedge_descriptor first = Graph_traits::null_halfedge();
  for(const auto& e : edges)
    if(seam_mesh.add_seam(source(e, tm), target(e, tm)) && first == Graph_traits::null_halfedge())
      first = halfedge(e, tm);
  return first;
}

} // namespace CGAL

#endif // CGAL_CUT_TO_DISK_H
