// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_EMBED_REEB_GRAPH_H
#define CGAL_EMBED_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/places_of_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/put_into_own_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file embed_reeb_graph.h
/// Embeds Reeb graphs in the middle of the solid.

namespace CGAL {

namespace Handle_tunnel_loops::internal {

/// Returns a Reeb graph on the arrays of its surface. \p index gives the numbers of vertices there.
template <typename Graph, typename IndexOfVertex>
Graph_of_parts
parts_of_graph(const Graph& graph, const Flat_mesh& mesh, const IndexOfVertex& index) {
  Graph_of_parts parts;
  for(const auto v : CGAL::make_range(vertices(graph)))
    parts.vertex_of_node.push_back(index(graph[v].vertex));
  parts.arcs.resize(num_edges(graph));
  parts.arc_of_vertex.assign(mesh.number_of_vertices(), no_index);
  for(const auto e : CGAL::make_range(edges(graph))) {
    const Index arc = static_cast<Index>(graph[e].index);
    parts.arcs[arc] = {static_cast<Index>(source(e, graph)), static_cast<Index>(target(e, graph))};
    for(const auto v : graph[e].vertices)
      parts.arc_of_vertex[index(v)] = arc;
  }
  return parts;
}

/// Assigns its polyline to an arc. Returns the number of segments that lie inside.
template <typename Arc>
std::size_t
take_line(const std::vector<Inner_ball>& line, const std::vector<char>& is_inside, Arc& arc) {
  using Point_of_arc = typename decltype(arc.polyline)::value_type;
  arc.polyline.clear();
  arc.radii.clear();
  arc.length = 0.;
  for(std::size_t i = 0; i < line.size(); ++i) {
    const Vector& p = line[i].centre;
    arc.polyline.emplace_back(Point_of_arc(p[0], p[1], p[2]));
    arc.radii.push_back(line[i].radius);
    if(i > 0)
      arc.length += norm(p - line[i - 1].centre);
  }
  arc.is_inside.assign(is_inside.begin(), is_inside.end());
  return static_cast<std::size_t>(std::count(is_inside.begin(), is_inside.end(), char(1)));
}

} // namespace Handle_tunnel_loops::internal

/*!
\ingroup PkgHandleTunnelLoopsRef

Embeds a Reeb graph in the middle of the solid that its surface encloses; where it has cavities,
between them and the component around them, as `curve_skeleton()` does. `reeb_graph()` draws the
arcs through the centroids of the contours, which is very fast but leaves the solid where contours
are not convex. This function replaces these polylines. It uses the same balls as `curve_skeleton()`
and takes about as long.

The nodes and arcs of the graph, and the vertices that belong to them, do not change.
`Reeb_node::point` moves to the middle of the solid near the vertex of the node; this also holds for
the end of a limb. `Reeb_arc::polyline` follows the middle of the part of the solid that the
vertices of the arc surround. If there is no path through this part, as in a flat ring whose
contours surround the hole, the polyline takes another path inside the solid. `Reeb_arc::radii`
reports the local thickness of the solid.

The computation uses a frame that depends on the shape only. If you rotate the mesh or renumber its
elements, the embedding stays the same, provided that the graph does. Polylines that run side by
side are kept slightly apart; `Reeb_embedding::embedded` reports whether no two of them meet.

Exact predicates on the coordinates of the mesh and the polylines, taken as doubles, decide whether
each segment lies strictly inside. If the surface neither crosses nor touches itself, all segments
do, unless the walls are too thin for the precision of doubles. On other surfaces, the segments that
are certified to lie inside are marked (`Reeb_arc::is_inside`).

The graph of a closed or capped surface has as many independent cycles as the genus, and it is
embedded so that these cycles are a basis of H1 of the solid, as for `curve_skeleton()`; call
`certify_curve_skeleton()` to certify it. Caps close the solid inside a surface with boundary. If
its graph was not computed with caps (`Reeb_options::capped`), it may have more cycles, and then
this certificate fails. It also fails for solids with cavities, where each surface has a graph of
its own.
If the contours bound inside, the polylines have this property by construction. If the contours
bound outside, as around the hole of a flat ring, all arcs between two nodes lie in the same place
and do not determine a hole; one of these arcs is then routed along the cheapest path around a hole
that no other cycle goes around.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph `Reeb_graph<TriangleMesh, Point>`, where `Point` is the value type of the vertex point
  map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param graph the Reeb graph of `tm`, computed by `reeb_graph()` or `reeb_graph_of_function()`
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

\return the properties of the embedding

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates

\sa `reeb_graph()`
\sa `curve_skeleton()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Graph,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Reeb_embedding
embed_reeb_graph(const TriangleMesh& tm,
                 Graph& graph,
                 const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  impl::Prepared_surface surface(execution, tm, vertex_index, point);
  std::vector<impl::Vector> places = impl::places_of_vertices(execution, surface);
  const auto frame = impl::put_into_own_frame(execution, surface, places);
  impl::Loop_request request = impl::loop_request({});
  request.classes.do_shorten = false; // any basis will do
  request.classes.do_link = true;     // which of them are handle loops
  request.make_passes = &impl::make_passes<ConcurrencyTag>;
  const std::vector<impl::Flat_pair> pairs = impl::loops_on_arrays(
      execution, surface.mesh, surface.coordinates(execution), std::move(request));
  impl::join_components_of_solids(execution, surface.mesh, places);
  const std::vector<impl::Index> flat = impl::indices_in_arrays(surface, vertex_index);
  const impl::Inner_drawing drawing =
      impl::draw_inside(execution, surface.mesh, *frame, places, pairs,
                        impl::parts_of_graph(graph, surface.mesh, [&](const auto v) {
                          return flat[get(vertex_index, v)];
                        }));

  Handle_tunnel_loops::Reeb_embedding result;
  for(const auto v : CGAL::make_range(vertices(graph))) {
    using Point_of_node = std::decay_t<decltype(graph[v].point)>;
    const impl::Vector& p = drawing.nodes[v].centre;
    graph[v].point = Point_of_node(p[0], p[1], p[2]);
    graph[v].radius = drawing.nodes[v].radius;
  }
  for(const auto e : CGAL::make_range(edges(graph))) {
    auto& arc = graph[e];
    result.number_of_segments += drawing.is_inside[arc.index].size();
    result.number_of_segments_inside +=
        impl::take_line(drawing.lines[arc.index], drawing.is_inside[arc.index], arc);
  }
  result.inside = result.number_of_segments_inside == result.number_of_segments;
  result.embedded = drawing.is_embedded;
  result.number_of_balls = drawing.number_of_balls;
  result.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  return result;
}

} // namespace CGAL

#endif // CGAL_EMBED_REEB_GRAPH_H
