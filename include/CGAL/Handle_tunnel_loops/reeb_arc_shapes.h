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
/// How thick a surface is along the arcs of its Reeb graph.

namespace CGAL {

/// \ingroup PkgHandleTunnelLoopsRef
/// How thick a surface is along the arcs of its Reeb graph, and which arcs lie on cycles.
struct Reeb_arc_shapes
{
  std::vector<double> girths; ///< by arc: see `reeb_arc_girths()`
  /// by arc, and by point of its polyline: the mean distance of the vertices that are nearest to
  /// it; where there are none, what is between those before and after. `Reeb_arc::radii`, if there
  /// are any.
  std::vector<std::vector<double>> radii;
  std::vector<bool> is_on_cycle; ///< by arc: whether the graph stays connected without it
};

/*!
\ingroup PkgHandleTunnelLoopsRef

computes for each arc of a Reeb graph how long its contour is half way, by the number of its
vertices. Where an arc goes down and up again, or has had limbs, there are several at that level:
then it is the longest.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph a `Reeb_graph<TriangleMesh, Point>`
\tparam VertexArcMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
  numbers as values
\tparam VertexValueMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys and
  `double` as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param graph its graph, as `reeb_graph()` or `reeb_graph_of_function()` computed it
\param vertex_arc what these wrote to the named parameter `vertex_arc_map`
\param vertex_value what they wrote to `vertex_value_map`
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

\return the lengths, by `Reeb_arc::index`
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

computes how thick a surface is along the arcs of its Reeb graph, and which of them lie on cycles.
What is given is the same as for `reeb_arc_girths()`.

\return the shapes, by `Reeb_arc::index`
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
