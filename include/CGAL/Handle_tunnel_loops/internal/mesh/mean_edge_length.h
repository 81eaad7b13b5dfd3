// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MEAN_EDGE_LENGTH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MEAN_EDGE_LENGTH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the mean length of some of the edges, spread over the mesh.
inline double mean_edge_length(const Flat_mesh& mesh) {
  const std::size_t n = mesh.number_of_vertices(), stride = n / 10000 + 1;
  double sum = 0.;
  std::size_t count = 0;
  for(std::size_t v = 0; v < n; v += stride, ++count)
    sum += mesh.edge_length(static_cast<Index>(v), mesh.ring(static_cast<Index>(v))[0]);
  return sum / double(count);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MEAN_EDGE_LENGTH_H
