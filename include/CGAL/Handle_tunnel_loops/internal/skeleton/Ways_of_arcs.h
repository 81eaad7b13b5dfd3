// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_WAYS_OF_ARCS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_WAYS_OF_ARCS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The ways of the arcs of a graph by balls, from node to node.
struct Ways_of_arcs
{
  using Way = std::vector<Index>;

  explicit Ways_of_arcs(const Graph_of_parts& graph_of_parts)
      : graph(graph_of_parts)
      , arcs_at(graph.vertex_of_node.size(), graph.arcs)
      , ball_of_node(graph.vertex_of_node.size(), no_index)
      , ways(graph.arcs.size()) {}

  Way from(Index node, Index arc) const {
    Way way = ways[arc];
    if(graph.arcs[arc][0] != node)
      std::reverse(way.begin(), way.end());
    return way;
  }

  void set_from(Index node, Index arc, Way way) {
    if(graph.arcs[arc][0] != node)
      std::reverse(way.begin(), way.end());
    ways[arc] = std::move(way);
  }

  bool are_ends_drawn(Index arc) const {
    const auto [lower, upper] = graph.arcs[arc];
    return ball_of_node[lower] != no_index && ball_of_node[upper] != no_index;
  }

  const Graph_of_parts& graph;
  Edges_at arcs_at;                // by node
  std::vector<Index> ball_of_node; ///< `no_index`: none
  std::vector<Way> ways;           ///< by arc
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_WAYS_OF_ARCS_H
