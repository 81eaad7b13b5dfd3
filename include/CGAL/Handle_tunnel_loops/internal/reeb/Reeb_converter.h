// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_CONVERTER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_CONVERTER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/find_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/properties.hpp>

#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Turns a Reeb graph on the flat mesh into one on the caller's mesh.
template <typename TriangleMesh, typename VertexPointMap, typename GeomTraits> class Reeb_converter
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  Reeb_converter(VertexPointMap point,
                 const GeomTraits& traits,
                 const Flat_mesh& mesh,
                 const std::vector<vertex_descriptor>& vertices)
      : point_(point)
      , traits_(traits)
      , mesh_(mesh)
      , vertices_(vertices)
      , origin_(coordinates(0) - mesh.in_units_of_caller(mesh.points[0])) {}

  /// Of `flat` no more is kept in memory than
  /// is still to be turned.
  template <typename Graph>
  void convert(Execution execution,
               Embedded_reeb_graph&& flat,
               const Function_on_vertices& function,
               Graph& graph) const {
    graph = Graph(flat.nodes.size());
    for(std::size_t i = 0; i < flat.nodes.size(); ++i)
      convert(flat.nodes[i], function, graph[i]);
    std::vector<typename boost::edge_bundle_type<Graph>::type*> arcs;
    arcs.reserve(flat.arcs.size());
    for(const Embedded_reeb_graph::Arc& arc : flat.arcs)
      arcs.push_back(&graph[add_edge(arc.lower, arc.upper, graph).first]);
    for_each_index(execution, arcs.size(), [&](std::size_t a) {
      const Embedded_reeb_graph::Arc arc = std::move(flat.arcs[a]);
      arcs[a]->index = a;
      convert(arc, graph[arc.lower].point, graph[arc.upper].point, *arcs[a]);
    });
  }

private:
  template <typename Arc>
  void convert(const Embedded_reeb_graph::Arc& flat,
               const Point& lower,
               const Point& upper,
               Arc& arc) const {
    CGAL_precondition(flat.line.size() >= 2);
    arc.length = mesh_.in_units_of_caller(length(flat.line));
    arc.polyline.reserve(flat.line.size());
    for(const Vector& p : flat.line)
      arc.polyline.push_back(place(p));
    arc.polyline.front() = lower;
    arc.polyline.back() = upper;
    arc.vertices.reserve(flat.vertices.size());
    for(Index v : flat.vertices)
      arc.vertices.push_back(vertices_[v]);
  }

  template <typename Node>
  void convert(const Flat_reeb_graph::Node& flat,
               const Function_on_vertices& function,
               Node& node) const {
    constexpr Reeb_node_type types[] = {Reeb_node_type::MINIMUM, Reeb_node_type::SADDLE,
                                        Reeb_node_type::MAXIMUM, Reeb_node_type::REGULAR};
    node.vertex = vertices_[flat.vertex];
    node.type = types[static_cast<int>(flat.kind)];
    node.value = function.value(flat.vertex);
    const bool is_extremum = flat.kind == Node_kind::MINIMUM || flat.kind == Node_kind::MAXIMUM;
    node.point = is_extremum ? Point(get(point_, node.vertex)) : place(flat.position);
  }

  Vector coordinates(Index v) const {
    const auto& p = get(point_, vertices_[v]);
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  Point place(const Vector& p) const {
    const Vector q = origin_ + mesh_.in_units_of_caller(p);
    return traits_.construct_point_3_object()(q[0], q[1], q[2]);
  }

  VertexPointMap point_;
  const GeomTraits& traits_;
  const Flat_mesh& mesh_;
  const std::vector<vertex_descriptor>& vertices_;
  Vector origin_; // of the unit box, in the caller's coordinates
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_CONVERTER_H
