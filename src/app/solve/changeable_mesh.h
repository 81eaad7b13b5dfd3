// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHANGEABLE_MESH_H
#define HTLOOPS_CHANGEABLE_MESH_H

#include "mesh_types.h"

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <vector>

namespace htloops {

/// What a mesh becomes in order to be changed.
using Changeable_mesh = CGAL::Surface_mesh<Point>;
using Changeable_pairs = std::vector<CGAL::Handle_tunnel_pair<Changeable_mesh>>;

/// A changeable copy of a mesh, with the numbers of its vertices and faces.
struct Changeable_copy
{
  Changeable_mesh mesh;
  std::vector<Changeable_mesh::Halfedge_index> halfedges; ///< by those of the original

  explicit Changeable_copy(const Mesh& original);

  /// loops of the original, on the copy while it has not been changed.
  Changeable_pairs pairs(const Pairs& pairs) const;
};

/// A number of what was there before, or `nothing_before`.
using Origins = std::vector<std::int64_t>;
constexpr std::int64_t nothing_before = -1;

/// A mesh that a copy has become; vertices and faces that were there come in their order, before
/// those that were not.
struct Changed_mesh
{
  Mesh mesh;
  Origins vertex_origins, face_origins;
  std::vector<std::size_t> faces; ///< of each face, its number in the copy
};

Changed_mesh changed_mesh(const Changeable_mesh& copy, const Mesh& original);

} // namespace htloops

#endif // HTLOOPS_CHANGEABLE_MESH_H
