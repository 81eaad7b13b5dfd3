// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_READER_H
#define HTLOOPS_MESH_READER_H

#include "mesh_types.h"
#include "read/input_file.h"

namespace htloops {

/// reads a closed triangle mesh; its vertices keep the numbers that they have in the file.
/// Throws `Failure` if the file cannot be read, or with all that is wrong with the mesh.
Mesh read_mesh(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_MESH_READER_H
