// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PATCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PATCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/patches/triangle_contacts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Faces that take the place of others. Corners are vertices of the mesh, or, from `first_own` on,
/// points of the patch.
struct Patch
{
  static constexpr Index first_own = Index(1) << 31;

  std::vector<Surgery_mesh::Point> points;
  std::vector<Surgery_mesh::Face> faces;
  /// the first faces may be parts of faces of the mesh, split at midpoints, and this says of which.
  std::vector<Index> parents = {};

  bool has_parent(std::size_t i) const { return i < parents.size(); }

  const Surgery_mesh::Point& point(const Surgery_mesh& mesh, Index v) const {
    return v < first_own ? mesh.point(v) : points[v - first_own];
  }

  Placed_triangle placed(const Surgery_mesh& mesh, std::size_t i) const {
    const Surgery_mesh::Face& f = faces[i];
    return {f, {point(mesh, f[0]), point(mesh, f[1]), point(mesh, f[2])}};
  }
};

/// puts a patch into the place of faces in ascending order. Returns the number of its first face.
inline Index put_in_place(Surgery_mesh& mesh, const std::vector<Index>& faces, const Patch& patch) {
  const Index shift = mesh.vertex_bound();
  for(const Surgery_mesh::Point& p : patch.points)
    mesh.add_vertex(p);
  std::vector<Surgery_mesh::Face> in = patch.faces;
  for(Surgery_mesh::Face& f : in)
    for(Index& v : f)
      if(v >= Patch::first_own)
        v = v - Patch::first_own + shift;
  return mesh.replace(faces, in);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PATCH_H
