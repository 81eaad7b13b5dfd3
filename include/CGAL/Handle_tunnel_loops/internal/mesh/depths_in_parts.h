// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_DEPTHS_IN_PARTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_DEPTHS_IN_PARTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// by vertex, how many edges there are to the next vertex of another part of the surface; 0 in
/// parts that are not wanted, or the only ones of their component. \p part_of_vertex has the hubs,
/// too.
template <typename IsWanted>
std::vector<Index> depths_in_parts(const Flat_mesh& mesh,
                                   const std::vector<Index>& part_of_vertex,
                                   const IsWanted& is_wanted) {
  std::vector<Index> depths(part_of_vertex.size(), 0), reached;
  for(Index v = 0; v < depths.size(); ++v) {
    const Index part = part_of_vertex[v];
    const Ring ring = mesh.ring(v);
    if(part != no_index && is_wanted(part) &&
       std::any_of(ring.begin(), ring.end(), [&](Index u) { return part_of_vertex[u] != part; }))
    {
      depths[v] = 1;
      reached.push_back(v);
    }
  }
  for(std::size_t i = 0; i < reached.size(); ++i)
    for(const Index u : mesh.ring(reached[i]))
      if(part_of_vertex[u] == part_of_vertex[reached[i]] && depths[u] == 0) {
        depths[u] = depths[reached[i]] + 1;
        reached.push_back(u);
      }
  return depths;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_DEPTHS_IN_PARTS_H
