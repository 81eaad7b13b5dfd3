// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_SURFACE_COUNT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_SURFACE_COUNT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What a closed surface is, by counting.
struct Surface_count
{
  std::size_t components = 0;
  std::size_t genus = 0; ///< summed over the components
};

/// whether each halfedge has a twin that leads back, and the faces at each vertex are one fan.
inline bool is_closed_manifold(const Surgery_mesh& mesh) {
  std::vector<Index> number_at(mesh.vertex_bound(), 0);
  for(Index h = 0; h < 3 * mesh.face_bound(); ++h)
    if(mesh.is_alive(mesh.face(h))) {
      const Index twin = mesh.twin(h);
      if(twin == no_index || !mesh.is_alive(mesh.face(twin)) || mesh.twin(twin) != h ||
         mesh.source(twin) != mesh.target(h) || mesh.target(twin) != mesh.source(h))
        return false;
      ++number_at[mesh.source(h)];
    }
  for(Index v = 0; v < mesh.vertex_bound(); ++v)
    if(mesh.outgoing(v) != no_index) {
      std::vector<Index> neighbors;
      mesh.for_each_outgoing(v, [&](Index h) { neighbors.push_back(mesh.target(h)); });
      if(neighbors.size() != number_at[v])
        return false;
      std::sort(neighbors.begin(), neighbors.end());
      if(std::adjacent_find(neighbors.begin(), neighbors.end()) != neighbors.end())
        return false;
    } else if(number_at[v] != 0)
      return false;
  return true;
}

/// throws `std::logic_error` if the mesh is no closed manifold, which nothing that is done to it
/// may make of it. Linear in the size of the mesh.
inline Surface_count count_surface(Execution execution, const Surgery_mesh& mesh) {
  if(!is_closed_manifold(mesh))
    throw std::logic_error("the surface is no closed manifold after the removal of handles");
  Surface_count count;
  count.components = number_of_pieces(execution, mesh, {});
  std::size_t vertices = 0;
  for(Index v = 0; v < mesh.vertex_bound(); ++v)
    vertices += mesh.outgoing(v) != no_index;
  // V - E + F = 2 c - 2 g, with 2 E = 3 F.
  count.genus = (2 * count.components + mesh.number_of_faces() / 2 - vertices) / 2;
  return count;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_SURFACE_COUNT_H
