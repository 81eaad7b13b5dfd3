// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_VERTEX_AREAS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_VERTEX_AREAS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// a third of the area of the faces at each vertex.
inline std::vector<double> vertex_areas(Execution execution, const Flat_mesh& mesh) {
  std::vector<double> areas(mesh.number_of_vertices());
  for_each_index(execution, areas.size(), [&](std::size_t i) {
    const Index v = static_cast<Index>(i);
    const Ring ring = mesh.ring(v);
    double sum = 0.;
    for(Index p = 0; p < ring.size(); ++p)
      sum += norm(cross(mesh.points[ring[p]] - mesh.points[v],
                        mesh.points[ring[ring.next(p)]] - mesh.points[v]));
    areas[v] = sum / 6.;
  });
  return areas;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_VERTEX_AREAS_H
