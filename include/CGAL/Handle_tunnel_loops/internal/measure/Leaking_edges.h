// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LEAKING_EDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LEAKING_EDGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Edge_names.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Named_forest.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Edges between points too far apart, that are wider than they are seen to be, and by which cycles of
new classes go. Without them there are none: so it is there that points are missing, all along a
cut.

Edges that are seen to be as wide as is asked for are taken first, then the others in the order of
falling radius, without those that close a cycle of a new class. Which are new is told by numbers
for the loops, random but for that they add up to nothing on all known classes.
*/
class Leaking_edges
{
public:
  Leaking_edges(const Ball_network& graph, const Edge_names& names, std::size_t number_of_loops)
      : graph_(graph)
      , names_(names)
      , number_of_loops_(number_of_loops) {}

  /// of cycles wider than a radius, independent of what is known. Edges of that radius have names.
  std::vector<Index> find(double radius, const Linking_rank& known) const {
    const std::vector<std::uint64_t> keys = known.numbers_without_sum(number_of_loops_);
    Named_forest forest(graph_.nodes.size());
    const auto join = [&](Index e) {
      return forest.join(graph_.edges[e].nodes[0], graph_.edges[e].nodes[1], name(e, keys));
    };
    std::vector<Index> doubtful;
    for(Index e = 0; e < graph_.edges.size(); ++e)
      if(graph_.edges[e].seen >= radius)
        join(e);
      else if(graph_.edges[e].radius >= radius)
        doubtful.push_back(e);
    std::sort(doubtful.begin(), doubtful.end(), [&](Index e, Index f) {
      const Ball_network::Edge &a = graph_.edges[e], &b = graph_.edges[f];
      return std::tie(b.radius, a.nodes) < std::tie(a.radius, b.nodes);
    });
    std::vector<Index> leaking;
    for(const Index e : doubtful)
      if(const auto around = join(e); around && Linking_rank::modulo(*around) != 0)
        leaking.push_back(e);
    return leaking;
  }

private:
  std::uint64_t name(Index edge, const std::vector<std::uint64_t>& keys) const {
    std::uint64_t sum = 0;
    if(names_.may_pass(edge))
      for(const auto& [loop, number] : names_.row(edge))
        sum += keys[loop] * static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
    return sum;
  }

  const Ball_network& graph_;
  const Edge_names& names_;
  std::size_t number_of_loops_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LEAKING_EDGES_H
