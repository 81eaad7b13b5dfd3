// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FACE_CUTS_H
#define HTLOOPS_FACE_CUTS_H

#include "mesh_types.h"

#include <optional>

namespace htloops {

/// Whether an edge lies across a face of the file, which was cut into triangles.
using Face_cuts = Mesh::Property_map<Mesh::Edge_index, bool>;

/// They go with the mesh.
inline Face_cuts add_face_cuts(Mesh& mesh) {
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:cuts_face", false).first;
}

/// nothing for a mesh whose faces all were triangles.
inline std::optional<Face_cuts> cuts_of_faces(const Mesh& mesh) {
  const auto [cuts, has_any] = mesh.property_map<Mesh::Edge_index, bool>("e:cuts_face");
  return has_any ? std::optional<Face_cuts>(cuts) : std::nullopt;
}

} // namespace htloops

#endif // HTLOOPS_FACE_CUTS_H
