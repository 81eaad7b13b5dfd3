// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_LOOP_WALKER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_LOOP_WALKER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Walk_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/are_collinear.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Turns loops on a mesh into closed walks on its edges, in time proportional to the loops,
/// whatever the size of the mesh.
template <typename TriangleMesh, typename VertexPointMap> class Loop_walker
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  using Walk = std::vector<halfedge_descriptor>;

  Loop_walker(const TriangleMesh& tm, VertexPointMap point)
      : tm_(tm)
      , point_(point) {}

  template <typename Loop> Walk operator()(const Loop& loop) const {
    const auto length = [this](halfedge_descriptor h) {
      return norm(position(target(h, tm_)) - position(source(h, tm_)));
    };
    Walk_improvement<TriangleMesh, decltype(length)> improvement(tm_, length, nearest_walk(loop));
    improvement.shorten();
    improvement.separate();
    return improvement.walk();
  }

private:
  Vector position(vertex_descriptor v) const { return coordinates(point_, v); }

  // The best walk by ends of the edges that the loop passes.
  template <typename Loop> Walk nearest_walk(const Loop& loop) const {
    std::vector<vertex_descriptor> ends; // by number
    for(const auto& step : loop.steps()) {
      ends.push_back(source(step.halfedge, tm_));
      ends.push_back(target(step.halfedge, tm_));
    }
    make_set(ends);
    const auto number = [&](vertex_descriptor v) {
      return static_cast<Index>(std::lower_bound(ends.begin(), ends.end(), v) - ends.begin());
    };
    std::vector<Edge_ends> places;
    for(const auto& step : loop.steps()) {
      const Index u = number(source(step.halfedge, tm_)), v = number(target(step.halfedge, tm_));
      places.push_back({step.ratio == 1. ? v : u, step.ratio == 0. ? u : v});
    }
    std::vector<Index> walk = shortest_walk_beside(
        places, [&](Index u, Index v) { return norm(position(ends[v]) - position(ends[u])); });
    remove_spurs(walk);
    Walk halfedges;
    for(std::size_t i = 0; i < walk.size() && walk.size() > 1; ++i) {
      const Index u = walk[i], v = walk[i + 1 == walk.size() ? 0 : i + 1];
      halfedges.push_back(halfedge_between(ends[u], ends[v]));
    }
    return halfedges;
  }

  halfedge_descriptor halfedge_between(vertex_descriptor u, vertex_descriptor v) const {
    const auto [h, is_edge] = halfedge(u, v, tm_);
    if(!is_edge)
      throw std::invalid_argument("consecutive places of the loop have no common face");
    return h;
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_LOOP_WALKER_H
