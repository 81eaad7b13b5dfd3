// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_CONTOUR_ABOVE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_CONTOUR_ABOVE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the contour of a function just above a regular vertex; what is below it is to its left.
inline Crossing_loop contour_above(const Flat_mesh& mesh,
                                   const Sweep_order& order,
                                   const std::vector<float>& function,
                                   Index v) {
  const Index level = order.rank(v) + 1;
  const Ring ring = mesh.ring(v);
  const Index* higher =
      std::find_if(ring.begin(), ring.end(), [&](Index u) { return order.rank(u) >= level; });
  CGAL_precondition(higher != ring.end());
  Contour_walk walk(mesh, order, level, v, *higher);
  Crossing_loop loop;
  do {
    const Index left = walk.left(), right = mesh.ring(left)[walk.position()];
    const float below = function[v] - function[left], all = function[right] - function[left];
    loop.push_back({left, right, all > 0.f ? (std::min)(double(below) / all, 1.) : 0.5});
    walk.advance(no_index);
  } while(walk.left() != v || mesh.ring(v)[walk.position()] != *higher);
  return loop;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_CONTOUR_ABOVE_H
