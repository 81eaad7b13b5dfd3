// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_check.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_shortening.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_start.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Sphere_ends.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/cut_open.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE void check_rules(const Cut_problem& problem) {
  if(problem.has_rules_of_caller)
    Cut_start(problem).find();
}

CGAL_HTL_CORE std::vector<Index> cut_graph(Cut_problem problem) {
  Sphere_ends(problem).add();
  Cut_graph cut = Cut_start(problem).find();
  Cut_shortening(problem, cut).run();
  Cut_check(problem, cut).run();
  std::vector<Index> edges;
  for(Index h = 0; h < problem.halfedges.size(); ++h)
    if(cut.contains(h) && problem.halfedges.source(h) < problem.halfedges.target(h))
      edges.push_back(h);
  return edges;
}

CGAL_HTL_CORE std::vector<Index> cut_open(Cut_problem problem) {
  std::vector<Index> edges = cut_graph(problem);
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [&](Index h) {
                               return problem.mesh.is_spoke(problem.halfedges.source(h),
                                                            problem.halfedges.target(h));
                             }),
              edges.end());
  return edges;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_IMPL_H
