// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FURTHEST_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FURTHEST_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the furthest vertex of each component; the first in the caller's order of several.
inline std::vector<Index> furthest_vertices(const Flat_mesh& mesh,
                                            const std::vector<float>& distance) {
  std::vector<Index> furthest = mesh.seeds;
  for(Index v = 0; v < distance.size(); ++v) {
    Index& best = furthest[mesh.component[v]];
    if(distance[v] > distance[best] ||
       (distance[v] == distance[best] && mesh.original[v] < mesh.original[best]))
      best = v;
  }
  return furthest;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FURTHEST_VERTICES_H
