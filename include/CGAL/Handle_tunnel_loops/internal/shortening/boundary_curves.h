// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BOUNDARY_CURVES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BOUNDARY_CURVES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the boundary curve around a hub, the surface to its left.
inline Crossing_loop boundary_curve(const Flat_mesh& mesh, Index hub) {
  const Ring ring = mesh.ring(hub);
  Crossing_loop loop;
  for(Index p = ring.size(); p-- > 0;)
    loop.push_back({ring[p], hub, 0.});
  return loop;
}

/// the curve a little inside of the surface. It enters no cap.
inline Crossing_loop beside_boundary(const Flat_mesh& mesh, Index hub) {
  const Ring ring = mesh.ring(hub);
  std::vector<Index> walk(ring.begin(), ring.end());
  std::reverse(walk.begin(), walk.end());
  return pushed_left(mesh, walk);
}

/// adds, of the boundary curves of each component, all but the last.
inline void add_boundaries_of_basis(const Flat_mesh& mesh, std::vector<Crossing_loop>& loops) {
  std::vector<Index> last(mesh.seeds.size(), no_index);
  const Index end = mesh.first_hub + mesh.number_of_hubs;
  for(Index hub = mesh.first_hub; hub < end; ++hub)
    last[mesh.component[hub]] = hub;
  for(Index hub = mesh.first_hub; hub < end; ++hub)
    if(last[mesh.component[hub]] != hub)
      loops.push_back(beside_boundary(mesh, hub));
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_BOUNDARY_CURVES_H
