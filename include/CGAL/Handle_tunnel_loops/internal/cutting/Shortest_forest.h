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
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <limits>

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
      , paths_(problem.mesh.number_of_vertices()) {}

  void add_source(Index v) { paths_.reach(v, {0., no_index}); }

  void grow() {
    const Flat_halfedges& halfedges = problem_.halfedges;
    paths_.grow([&](Index v) {
      for(Index h = halfedges.begin(v); h < halfedges.end(v); ++h) {
        const double sum = distance(v) + problem_.weight[h];
        if(sum < distance(halfedges.target(h)) && !problem_.is_avoided(h))
          paths_.reach(halfedges.target(h), {sum, h});
      }
    });
  }

  /// from the nearest source; `never` where no path leads.
  double distance(Index v) const { return paths_[v].distance; }

  /// whether a halfedge or its twin is on the path to one of its ends.
  bool is_on_path(Index h) const {
    return paths_[problem_.halfedges.target(h)].previous == h ||
           paths_[problem_.halfedges.source(h)].previous == problem_.halfedges.twin(h);
  }

private:
  struct Label
  {
    double distance = never;
    Index previous = no_index; // the halfedge that leads to the vertex
  };

  const Cut_problem& problem_;
  Shortest_paths<Label> paths_; // by vertex
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_FOREST_H
