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
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <iterator>
#include <vector>

/// \file loops_as_edges.h
/// Loops on a mesh as closed walks on its edges.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

moves a loop onto the edges of its mesh: writes a closed walk of halfedges in the homotopy class of
the loop, each halfedge beginning where the one before it ends.

Each place of the loop moves to one end of its edge. Of all these walks the shortest is taken; then
it goes around a vertex wherever that is shorter, and around those that it passes twice, if there is
room. So almost always it is simple; where it is not, as on a tube three edges around that a loop
passes twice, some vertex is passed more than once. The time is proportional to the length of
the loop, whatever the size of the mesh.

\tparam TriangleMesh a model of `HalfedgeGraph` with triangles as faces, and no boundary near the
  loop
\tparam Loop `Loop_on_surface<TriangleMesh>`, or a type with a member function `steps()` like its
  own
\tparam OutputIterator a model of `OutputIterator` that accepts
  `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loop the loop
\param tm the mesh
\param out the iterator that the halfedges are written to; nothing if the loop is contracted by
  these moves
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last halfedge written

\throws std::invalid_argument if consecutive places of the loop have no common face

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

namespace Handle_tunnel_loops::internal {

/// calls `f` for each loop of a pair, or for a loop.
template <typename TriangleMesh, typename Point, typename Function>
void for_each_loop_of(const Handle_tunnel_pair<TriangleMesh, Point>& pair, const Function& f) {
  f(pair.handle());
  f(pair.tunnel());
}
template <typename Loop, typename Function>
void for_each_loop_of(const Loop& loop, const Function& f) {
  f(loop);
}

} // namespace Handle_tunnel_loops::internal

/*!
\ingroup PkgHandleTunnelLoopsRef

marks the edges of loops that `loop_to_halfedges()` finds: sets the property map to `true` for them,
and leaves it as it is for other edges. So marked, they are what the property map
`edge_is_constrained_map` of other functions takes: a selection for display, or walls for
`Polygon_mesh_processing::connected_components()`.

\tparam LoopRange a range of `Loop_on_surface<TriangleMesh>` or of
  `Handle_tunnel_pair<TriangleMesh>`, of which both loops are taken
\tparam TriangleMesh a model of `HalfedgeGraph` with triangles as faces
\tparam EdgeMarkMap a model of `WritablePropertyMap` with the edges of the mesh as keys and `bool`
  as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loops the loops
\param tm the mesh
\param edge_mark the property map
\param np named parameters: `vertex_point_map`, as of `loop_to_halfedges()`

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

makes loops edges of their mesh: divides the faces that they cross along them, and into triangles
again. The points of the loops become vertices as they are; where two loops cross in a face, there
is a new vertex. Loops may pass vertices, run along edges, and go through a face several times.

The mesh stays closed and a manifold, with the same Euler characteristic: only edges and faces are
split. In exact terms new vertices lie on the surface only up to rounding.

Loops that were not passed refer to halfedges that may be others afterwards: all loops have to be
passed at once.

\tparam LoopRange a range of `Loop_on_surface<TriangleMesh>` or of
  `Handle_tunnel_pair<TriangleMesh>`, of which both loops are taken
\tparam TriangleMesh a model of `MutableFaceGraph` with triangles as faces
\tparam OutputIterator a model of `OutputIterator` that accepts
  `std::vector<boost::graph_traits<TriangleMesh>::%halfedge_descriptor>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loops the loops
\param tm the mesh
\param out the iterator that the closed walk of each loop is written to, in their order
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadWritePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{is set to `true` for the edges of the loops, and left as it is for others}
    \cgalParamType{a class model of `WritablePropertyMap` with the edges of `tm` as keys and `bool`
      as value type}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{face_to_face_map}
    \cgalParamDescription{is given, for each part of a face that was divided, that face, which is
      one of the parts}
    \cgalParamType{a class model of `WritablePropertyMap` with the faces of `tm` as keys and as
      values}
    \cgalParamDefault{unused}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last walk written

\throws std::invalid_argument if consecutive places of a loop have no common face; the mesh has not
  been changed then

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
