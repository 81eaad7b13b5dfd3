// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_COPIES_H
#define HTLOOPS_COPIES_H

#include "clean/parts.h"
#include "solve/changeable_mesh.h"

#include <vector>

namespace htloops {

/// by part, whether one before it has the same triangles at the same places, in either orientation.
/// Linear in the size of the mesh but for sorting the triangles of parts with equal boxes.
std::vector<char> find_copies(const Changeable_mesh& mesh, const Parts& parts);

} // namespace htloops

#endif // HTLOOPS_COPIES_H
