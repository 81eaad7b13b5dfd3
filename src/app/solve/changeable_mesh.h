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

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace htloops {

/// What a mesh becomes in order to be changed. Its kernel decides exactly.
using Changeable_mesh =
    CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Changeable_pairs = std::vector<CGAL::Handle_tunnel_pair<Changeable_mesh>>;

/// the points of the corners of a face.
inline std::array<Changeable_mesh::Point, 3> corners_of(const Changeable_mesh& mesh,
                                                        Changeable_mesh::Face_index f) {
  const Changeable_mesh::Halfedge_index h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

/// A changeable copy of a mesh, with the numbers of its vertices and faces.
struct Changeable_copy
{
  Changeable_mesh mesh;
  std::vector<Changeable_mesh::Halfedge_index> halfedges; ///< by those of the original

  /// what is put in gets new numbers, whatever is taken out.
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
  Origins face_parents; ///< of which face before each face is a part, or which one it was
  std::vector<std::size_t> faces = {}; ///< of each face, its number in the copy
};

/// faces of a copy that are parts of what was there before.
using Face_parents = std::map<Changeable_mesh::Face_index, Changeable_mesh::Face_index>;

Changed_mesh
changed_mesh(const Changeable_mesh& copy, const Mesh& original, const Face_parents& parents = {});

/// a mesh that has not been changed yet.
Changed_mesh unchanged_mesh(const Mesh& mesh);

/// what was changed twice, by what was there before the first change.
Changed_mesh composed(const Changed_mesh& first, Changed_mesh second);

} // namespace htloops

#endif // HTLOOPS_CHANGEABLE_MESH_H
