// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SPHERE_ENDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SPHERE_ENDS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Shortest_forest.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/component_sizes.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Gives the arcs of spheres their ends, as cones: where the caller wants one or names one vertex,
/// a sphere is cut from there, or from one end of it, to the vertex farthest away.
class Sphere_ends
{
public:
  explicit Sphere_ends(Cut_problem& problem)
      : problem_(problem) {}

  void add() {
    const std::vector<Component_size> sizes = component_sizes(problem_);
    std::vector<Index> number_of_cones(sizes.size(), 0), some_cone(sizes.size(), no_index);
    for(Index v = 0; v < problem_.cones.size(); ++v)
      if(problem_.is_cone(v)) {
        ++number_of_cones[problem_.mesh.component[v]];
        some_cone[problem_.mesh.component[v]] = v;
      }
    std::vector<char> is_kept(sizes.size(), 0);
    for(Index h = 0; h < problem_.rules.size(); ++h)
      if(problem_.is_kept(h))
        is_kept[problem_.mesh.component[problem_.halfedges.source(h)]] = 1;
    for(std::size_t c = 0; c < sizes.size(); ++c)
      if(sizes[c].genus() == 0 && !is_kept[c]) {
        if(number_of_cones[c] == 1 && problem_.mesh.is_hub(some_cone[c]))
          problem_.cones[some_cone[c]] = 0; // a disk as it is
        else if(number_of_cones[c] == 1)
          add_cone(farthest_from(some_cone[c]));
        else if(number_of_cones[c] == 0 && problem_.do_cut_spheres) {
          const Index end = farthest_from(problem_.mesh.seeds[c]);
          add_cone(end);
          add_cone(farthest_from(end));
        }
      }
  }

private:
  void add_cone(Index v) {
    problem_.cones.resize(problem_.mesh.number_of_vertices(), 0);
    problem_.cones[v] = 1;
  }

  Index farthest_from(Index v) const {
    Shortest_forest forest(problem_);
    forest.add_source(v);
    forest.grow();
    Index farthest = problem_.halfedges.target(problem_.halfedges.begin(v));
    for(Index u = 0; u < problem_.mesh.number_of_vertices(); ++u)
      if(forest.distance(u) != Shortest_forest::never &&
         forest.distance(u) > forest.distance(farthest))
        farthest = u;
    return farthest;
  }

  Cut_problem& problem_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SPHERE_ENDS_H
