// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SEAM_SCRIPT_H
#define HTLOOPS_SEAM_SCRIPT_H

#include "mesh_types.h"

#include <string>
#include <vector>

namespace htloops {

/// writes a program for Blender that marks edges as seams on the mesh of a file, imported there: on
/// the objects that have it, or it imports the file itself, if the mesh is in one. Vertices are
/// those of the file, and edges are edges of its faces.
void write_seam_script(const std::string& target,
                       const std::string& mesh_file,
                       const Mesh& mesh,
                       const std::vector<Mesh::Edge_index>& seams);

} // namespace htloops

#endif // HTLOOPS_SEAM_SCRIPT_H
