// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_ABOVE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_ABOVE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// calls `f` for the lower and the higher end of each edge that the contour just above a vertex
/// crosses, which is no saddle and no maximum; what is below is to the left. The first edge, which
/// begins at the vertex, comes once more at the end.
template <typename Function>
void for_each_crossing_above(const Flat_mesh& mesh,
                             const Sweep_order& order,
                             Index v,
                             const Function& f) {
  const Index level = order.rank(v) + 1;
  const Ring ring = mesh.ring(v);
  const Index* higher =
      std::find_if(ring.begin(), ring.end(), [&](Index u) { return order.rank(u) >= level; });
  CGAL_precondition(higher != ring.end());
  Contour_walk walk(mesh, order, level, v, *higher);
  f(v, *higher);
  do {
    walk.advance(no_index);
    f(walk.left(), mesh.ring(walk.left())[walk.position()]);
  } while(walk.left() != v || mesh.ring(v)[walk.position()] != *higher);
}

/// the contour of a function just above a vertex, which is no saddle and no maximum; what is below
/// it is to its left.
inline Crossing_loop contour_above(const Flat_mesh& mesh,
                                   const Sweep_order& order,
                                   const std::vector<float>& function,
                                   Index v) {
  Crossing_loop loop;
  for_each_crossing_above(mesh, order, v, [&](Index left, Index right) {
    const float below = function[v] - function[left], all = function[right] - function[left];
    loop.push_back({left, right, all > 0.f ? (std::min)(double(below) / all, 1.) : 0.5});
  });
  loop.pop_back();
  return loop;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_ABOVE_H
