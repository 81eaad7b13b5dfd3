// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_EXPORT_GLTF_H
#define HTLOOPS_EXPORT_GLTF_H

#include "draw/exported_lines.h"
#include "draw/mesh_arrays.h"

#include <string>

namespace htloops {

/// writes a surface and tubes around lines as a binary file of glTF 2.0, each line a node with its
/// name. Throws `Failure` if the surface is too large or too small for the numbers of that format.
void export_gltf(const std::string& file,
                 const Drawn_surface& surface,
                 const Exported_lines& lines);

/// throws `Failure` unless the name of a file ends in .glb.
void check_gltf_format(const std::string& file);

} // namespace htloops

#endif // HTLOOPS_EXPORT_GLTF_H
