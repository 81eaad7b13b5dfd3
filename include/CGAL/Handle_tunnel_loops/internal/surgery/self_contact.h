// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SELF_CONTACT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SELF_CONTACT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// whether two faces meet elsewhere than in a common vertex or edge, or a face has no area: then
/// the surface is not the boundary of a solid. Decided exactly, of faces whose boxes meet. Takes
/// about as long as reading the mesh, and a few times as long where the boxes of most of them meet,
/// as they are long, or large and in many layers. (`Polygon_mesh_processing::does_self_intersect()`
/// says the same, but does not let itself be interrupted, and copies the mesh.)
/// \p points are those of the corners of the faces.
bool touches_itself(Execution execution,
                    const std::vector<Vector>& points,
                    const std::vector<std::array<Index, 3>>& faces);

/// the same for a surface with the caps that close its boundary curves. \p places are those of its
/// vertices, hubs included.
bool touches_itself(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& places);

/// the same for a mesh of the caller.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
bool touches_itself(Execution execution,
                    const TriangleMesh& tm,
                    VertexPointMap point,
                    VertexIndexMap index) {
  std::vector<Vector> points;
  for(const auto v : vertices(tm)) {
    const std::size_t i = get(index, v);
    points.resize((std::max)(points.size(), i + 1));
    points[i] = coordinates(point, v);
  }
  std::vector<std::array<Index, 3>> corners;
  for(const auto f : faces(tm)) {
    corners.emplace_back();
    std::size_t corner = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, tm), tm))
      corners.back()[corner++] = static_cast<Index>(get(index, v));
  }
  return touches_itself(execution, points, corners);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SELF_CONTACT_H
