// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_FOREST_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_FOREST_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Shortest paths from some vertices to all others, along edges that are not to be avoided.
class Shortest_forest
{
public:
  static constexpr double never = (std::numeric_limits<double>::max)();

  explicit Shortest_forest(const Cut_problem& problem)
      : problem_(problem)
      , distance_(problem.mesh.number_of_vertices(), never)
      , previous_(problem.mesh.number_of_vertices(), no_index) {}

  void add_source(Index v) {
    distance_[v] = 0.;
    queue_.push({0., v});
  }

  void grow() {
    const Flat_halfedges& halfedges = problem_.halfedges;
    while(!queue_.empty()) {
      const auto [d, v] = queue_.top();
      queue_.pop();
      if(d > distance_[v])
        continue;
      for(Index h = halfedges.begin(v); h < halfedges.end(v); ++h) {
        const Index u = halfedges.target(h);
        const double sum = d + problem_.weight[h];
        if(sum < distance_[u] && !problem_.is_avoided(h)) {
          distance_[u] = sum;
          previous_[u] = h;
          queue_.push({sum, u});
        }
      }
    }
  }

  /// from the nearest source; `never` where no path leads.
  double distance(Index v) const { return distance_[v]; }

  /// whether a halfedge or its twin is on the path to one of its ends.
  bool is_on_path(Index h) const {
    return previous_[problem_.halfedges.target(h)] == h ||
           previous_[problem_.halfedges.source(h)] == problem_.halfedges.twin(h);
  }

private:
  using Entry = std::pair<double, Index>;

  const Cut_problem& problem_;
  std::vector<double> distance_;
  std::vector<Index> previous_; // the halfedge that leads to the vertex
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_FOREST_H
