// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_REEB_ARC_SHAPES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_REEB_ARC_SHAPES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/arc_shapes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <vector>

/// \file reeb_arc_shapes.h
/// Computes the thickness of a surface along the arcs of its Reeb graph.

namespace CGAL {

/// \ingroup PkgHandleTunnelLoopsRef
/// The thickness of a surface along the arcs of its Reeb graph, and which arcs lie on cycles.
struct Reeb_arc_shapes
{
  std::vector<double> girths; ///< by arc: the girth, see `reeb_arc_girths()`
  /// by arc, and by point of its polyline: the mean distance to the vertices nearest to the point,
  /// interpolated between adjacent points if there are none. If `Reeb_arc::radii` is not empty, it
  /// is used instead.
  std::vector<std::vector<double>> radii;
  std::vector<bool> is_on_cycle; ///< by arc: whether the graph remains connected without it
};

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes the girth of each arc of a Reeb graph: the length of one of its contours, the polyline in
which the mesh is cut just below the middle vertex of the arc, at the value of that vertex. The
middle vertex has position n/2, rounded down, among the n vertices of the arc
(`Reeb_arc::vertices`).

In the full Reeb graph, this contour is unique. In a simplified graph, an arc may have several
contours at this value, because it goes down and up again or because limbs were removed; the girth
is the length of the contour that crosses most edges between vertices of the arc; if none crosses
any, of the longest one beside the middle vertex. An arc without vertices is cut just below its
upper node. The girth is 0 if the middle vertex is a minimum. Caps are not part of the mesh: the
girth does not count what a contour runs across them.

The running time is linear in the size of the mesh and in the lengths of these contours.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph `Reeb_graph<TriangleMesh, Point>`
\tparam VertexArcMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
  numbers as values
\tparam VertexValueMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
  `double` as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param graph the Reeb graph of `tm`, computed by `reeb_graph()` or `reeb_graph_of_function()`
\param vertex_arc the map that this function has filled as the named parameter `vertex_arc_map`
\param vertex_value the map that it has filled as the named parameter `vertex_value_map`
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
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

\return the girths, indexed by `Reeb_arc::index`
*/
template <typename TriangleMesh,
          typename Graph,
          typename VertexArcMap,
          typename VertexValueMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::vector<double> reeb_arc_girths(const TriangleMesh& tm,
                                    const Graph& graph,
                                    VertexArcMap vertex_arc,
                                    VertexValueMap vertex_value,
                                    const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  const auto index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  return impl::girths_of_arcs(impl::Vertices_on_arcs(tm, index, vertex_arc, vertex_value), graph,
                              point);
}

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes the thickness of a surface along the arcs of its Reeb graph, and which arcs lie on cycles.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph `Reeb_graph<TriangleMesh, Point>`
\tparam VertexArcMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
  numbers as values
\tparam VertexValueMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
  `double` as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param graph the Reeb graph of `tm`, computed by `reeb_graph()` or `reeb_graph_of_function()`
\param vertex_arc the map that this function has filled as the named parameter `vertex_arc_map`
\param vertex_value the map that it has filled as the named parameter `vertex_value_map`
\param np an optional sequence of named parameters: `vertex_point_map` and `vertex_index_map`, as in
  `reeb_arc_girths()`

\return the shapes, indexed by `Reeb_arc::index`
*/
template <typename TriangleMesh,
          typename Graph,
          typename VertexArcMap,
          typename VertexValueMap,
          typename NamedParameters = parameters::Default_named_parameters>
Reeb_arc_shapes reeb_arc_shapes(const TriangleMesh& tm,
                                const Graph& graph,
                                VertexArcMap vertex_arc,
                                VertexValueMap vertex_value,
                                const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  Reeb_arc_shapes shapes;
  shapes.girths = reeb_arc_girths(tm, graph, vertex_arc, vertex_value, np);
  shapes.is_on_cycle = impl::arcs_on_cycles(graph);
  shapes.radii.resize(shapes.girths.size());
  for(const auto e : CGAL::make_range(edges(graph))) {
    const auto& arc = graph[e];
    shapes.radii[arc.index] =
        arc.radii.empty() ? impl::radii_of_arc(arc, point, shapes.girths[arc.index]) : arc.radii;
  }
  return shapes;
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REEB_ARC_SHAPES_H
