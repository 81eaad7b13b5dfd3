// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_LOOPS_THROUGH_VERTEX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_LOOPS_THROUGH_VERTEX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Swept_function.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/surface_distances.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Loops through a vertex, on the contours of the distance from it. At each saddle two ways from there
meet, and are a loop: where contours meet, one of these is crossed once; where one parts, the loop
is around either part.
*/
class Loops_through_vertex
{
public:
  Loops_through_vertex(Execution execution, const Flat_mesh& mesh, Index vertex)
      : mesh_(mesh)
      , vertex_(vertex)
      , function_(execution, mesh, surface_distances(mesh, source_in_each_component())) {}

  /// calls `f(loop)` from near ones to far ones, until it returns true.
  template <typename Function> void for_each_until(const Function& f) const {
    Index last = no_index;
    for(const Flat_reeb_graph::Node& node : function_.graph().nodes) {
      if(node.kind != Node_kind::SADDLE || node.vertex == last || mesh_.is_hub(node.vertex) ||
         mesh_.component[node.vertex] != mesh_.component[vertex_])
        continue;
      last = node.vertex;
      for(Crossing_loop& loop : loops_at(node.vertex))
        if(f(std::move(loop)))
          return;
    }
  }

private:
  std::vector<Index> source_in_each_component() const {
    std::vector<Index> sources = mesh_.seeds;
    sources[mesh_.component[vertex_]] = vertex_;
    return sources;
  }

  std::vector<Crossing_loop> loops_at(Index saddle) const {
    const Swept_vertex at(mesh_, function_.order(), saddle);
    std::vector<std::vector<Index>> ways;
    for(Index i = 0; i < at.number_of_lower_components(); ++i) {
      Index best = no_index;
      at.for_each_below(i, [&](Index p) { take_if_steeper(saddle, mesh_.ring(saddle)[p], best); });
      ways.push_back(way_down(best));
    }
    std::vector<Crossing_loop> loops;
    for(std::size_t i = 0; i + 1 < ways.size(); ++i) {
      std::vector<Index> walk(ways[i].rbegin(), ways[i].rend());
      walk.push_back(saddle);
      walk.insert(walk.end(), ways[i + 1].begin(), ways[i + 1].end() - 1);
      if(Crossing_loop loop = loop_along(mesh_, std::move(walk)); !loop.empty())
        loops.push_back(std::move(loop));
    }
    return loops;
  }

  double slope(Index from, Index to) const {
    const double step = mesh_.edge_length(from, to);
    return step > 0. ? (double(function_.values()[from]) - function_.values()[to]) / step
                     : (std::numeric_limits<double>::max)();
  }

  void take_if_steeper(Index from, Index to, Index& best) const {
    if(best == no_index || slope(from, to) > slope(from, best))
      best = to;
  }

  // To the vertex; each vertex but that one has a lower neighbour, from which it was reached.
  std::vector<Index> way_down(Index v) const {
    std::vector<Index> way;
    for(Index best = v; best != no_index;) {
      way.push_back(best);
      v = std::exchange(best, no_index);
      for(const Index u : mesh_.ring(v))
        if(function_.order().rank(u) < function_.order().rank(v) && !mesh_.is_hub(u))
          take_if_steeper(v, u, best);
    }
    return way;
  }

  const Flat_mesh& mesh_;
  Index vertex_;
  Swept_function function_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_LOOPS_THROUGH_VERTEX_H
