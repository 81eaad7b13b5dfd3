// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_CONVERTER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_CONVERTER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Whether the vertices of a skeleton have all that `Curve_skeleton_vertex` has, or only a point
/// and vertices, as those of the skeletons of other packages.
template <typename Vertex, typename = void> struct Has_radius : std::false_type
{};
template <typename Vertex>
struct Has_radius<Vertex, std::void_t<decltype(std::declval<Vertex&>().radius)>> : std::true_type
{};

/// assigns a skeleton to a graph of the caller.
template <typename Prepared, typename Graph>
void convert_skeleton(const Prepared& surface, const Found_skeleton& found, Graph& graph) {
  using Vertex = std::decay_t<decltype(graph[*vertices(graph).first])>;
  using Point_of_graph = std::decay_t<decltype(std::declval<Vertex&>().point)>;
  const Flat_skeleton& flat = found.skeleton;
  Graph result;
  std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> descriptors;
  for(std::size_t p = 0; p < flat.points.size(); ++p) {
    const auto v = add_vertex(result);
    descriptors.push_back(v);
    result[v].point = Point_of_graph(flat.points[p][0], flat.points[p][1], flat.points[p][2]);
    if constexpr(Has_radius<Vertex>::value) {
      result[v].radius = flat.radii[p];
      result[v].component = flat.component_of[p];
      result[v].is_inlet = flat.is_inlet[p] != 0;
    }
  }
  for(const auto& edge : flat.edges)
    add_edge(descriptors[edge[0]], descriptors[edge[1]], result);
  for(std::size_t v = 0; v < surface.vertices.size(); ++v)
    if(const Index p = found.point_of_vertex[v]; p != no_index)
      result[descriptors[p]].vertices.push_back(surface.vertices[v]);
  graph = std::move(result);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_CONVERTER_H
