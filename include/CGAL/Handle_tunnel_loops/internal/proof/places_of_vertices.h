// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_PLACES_OF_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_PLACES_OF_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the coordinates of the vertices of a surface as its caller has them, hubs included.
template <typename Prepared>
std::vector<Vector> places_of_vertices(Execution execution, const Prepared& surface) {
  std::vector<Vector> places;
  for(const auto& p : surface.coordinates(execution))
    places.push_back({p.x(), p.y(), p.z()});
  place_hubs(execution, surface.mesh, places);
  return places;
}

/// The vertices of the caller by their indices in the arrays.
template <typename Prepared, typename VertexIndexMap>
std::vector<Index> indices_in_arrays(const Prepared& surface, VertexIndexMap vertex_index) {
  std::vector<Index> flat;
  for(Index i = 0; i < surface.vertices.size(); ++i) {
    const std::size_t v = get(vertex_index, surface.vertices[i]);
    if(v >= flat.size())
      flat.resize(v + 1, no_index);
    flat[v] = i;
  }
  return flat;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_PLACES_OF_VERTICES_H
