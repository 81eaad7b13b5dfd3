// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_LOOPS_AS_EDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_LOOPS_AS_EDGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Loop_imprint.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Walk_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/for_each_loop_of.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <iterator>
#include <vector>

/// \file loops_as_edges.h
/// Converts loops on a mesh to closed walks along its edges.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Moves a loop onto the edges of its mesh. Writes a closed walk of halfedges in the homotopy class of
the loop, where each halfedge begins at the target of the one before.

Each point of the loop moves to one end of its edge. The function takes the shortest of all these
walks. It then reroutes the walk around a vertex wherever this shortens it, and around vertices that
the walk passes twice, if there is room. The walk is therefore almost always simple. It may pass a
vertex more than once where this is impossible, for example on a tube with three edges around that
the loop passes twice. The running time is proportional to the length of the loop and does not
depend on the size of the mesh.

\tparam TriangleMesh a model of `HalfedgeGraph` with triangles as faces
\tparam Loop `Loop_on_surface<TriangleMesh>`, or a type with the same member function `steps()`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loop the loop
\param tm the mesh
\param out the output iterator that receives the halfedges; nothing is written if these moves
  contract the loop
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last halfedge written

\pre `tm` has no boundary close to the loop.

\throws std::invalid_argument if consecutive points of the loop have no common face

\sa `mark_loop_edges()`
*/
template <typename Loop,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator loop_to_halfedges(const Loop& loop,
                                 const TriangleMesh& tm,
                                 OutputIterator out,
                                 const NamedParameters& np = parameters::default_values()) {
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  const auto halfedges = Handle_tunnel_loops::internal::halfedges_of_loop(loop, tm, point);
  return std::copy(halfedges.begin(), halfedges.end(), out);
}

/*!
\ingroup PkgHandleTunnelLoopsRef

Marks the edges of loops as `loop_to_halfedges()` computes them: sets the property map to `true` for
these edges and leaves it unchanged for all others. You can pass the map as the parameter
`edge_is_constrained_map` of other functions, for example as barriers of
`Polygon_mesh_processing::connected_components()`, or use it as a selection for display.

\tparam LoopRange a range of `Loop_on_surface<TriangleMesh>`, or of
  `Handle_tunnel_pair<TriangleMesh>` to use both loops of each pair
\tparam TriangleMesh a model of `HalfedgeGraph` with triangles as faces
\tparam EdgeMarkMap a model of `WritablePropertyMap` with the edges of the mesh as keys and `bool`
  as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loops the loops
\param tm the mesh
\param edge_mark the property map
\param np an optional sequence of named parameters: `vertex_point_map`, as in `loop_to_halfedges()`

\throws std::invalid_argument if consecutive points of a loop have no common face

\sa `loop_to_halfedges()`
*/
template <typename LoopRange,
          typename TriangleMesh,
          typename EdgeMarkMap,
          typename NamedParameters = parameters::Default_named_parameters>
void mark_loop_edges(const LoopRange& loops,
                     const TriangleMesh& tm,
                     EdgeMarkMap edge_mark,
                     const NamedParameters& np = parameters::default_values()) {
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  std::vector<Halfedge> walk;
  for(const auto& item : loops)
    Handle_tunnel_loops::internal::for_each_loop_of(
        item, [&](const auto& loop) { loop_to_halfedges(loop, tm, std::back_inserter(walk), np); });
  for(const Halfedge h : walk)
    put(edge_mark, edge(h, tm), true);
}

/*!
\ingroup PkgHandleTunnelLoopsRef

Makes loops edges of their mesh: divides the faces that they cross, and triangulates the parts. The
points of the loops become vertices without moving. Where two loops cross in a face, a vertex is
added. Loops may pass through vertices, run along edges, and pass through a face several times.

A closed mesh stays closed. The mesh remains a manifold and has the same Euler characteristic,
because edges and faces are only split. The new vertices lie on the original surface up to rounding.

Pass all loops in one call: loops that are not passed refer to halfedges that may change.

\tparam LoopRange a range of `Loop_on_surface<TriangleMesh>`, or of
  `Handle_tunnel_pair<TriangleMesh>` to use both loops of each pair
\tparam TriangleMesh a model of `MutableFaceGraph` with triangles as faces
\tparam OutputIterator a model of `OutputIterator` that accepts
  `std::vector<boost::graph_traits<TriangleMesh>::%halfedge_descriptor>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loops the loops
\param tm the mesh; the function modifies it
\param out the output iterator that receives the closed walk of each loop, in the order of the loops
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadWritePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{receives `true` for the edges of the loops; unchanged for all others}
    \cgalParamType{a class model of `WritablePropertyMap` with the edges of `tm` as keys and `bool`
      as value type}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{face_to_face_map}
    \cgalParamDescription{receives, for each part of a face that was divided, the original face,
      which remains in the mesh as one of the parts}
    \cgalParamType{a class model of `WritablePropertyMap` with the faces of `tm` as keys and as
      values}
    \cgalParamDefault{unused}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last walk written

\throws std::invalid_argument if consecutive points of a loop have no common face; the mesh is
  unchanged

\sa `loop_to_halfedges()`
*/
template <typename LoopRange,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator imprint_loops(const LoopRange& loops,
                             TriangleMesh& tm,
                             OutputIterator out,
                             const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  const auto point = parameters::choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                  get_property_map(vertex_point, tm));
  impl::Loop_imprint imprint(tm, point);
  for(const auto& item : loops)
    impl::for_each_loop_of(item, [&](const auto& loop) { imprint.add(loop); });
  const auto walks = imprint.run();
  if constexpr(!is_default_parameter<NamedParameters, internal_np::edge_is_constrained_t>::value) {
    auto marks = get_parameter(np, internal_np::edge_is_constrained);
    for(const auto& walk : walks)
      for(const auto h : walk)
        put(marks, edge(h, tm), true);
  }
  if constexpr(!is_default_parameter<NamedParameters, internal_np::face_to_face_map_t>::value) {
    auto origins = get_parameter(np, internal_np::face_to_face_map);
    imprint.for_each_part(
        [&](const auto& part, const auto& origin) { put(origins, part, origin); });
  }
  return std::copy(walks.begin(), walks.end(), out);
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOPS_AS_EDGES_H
