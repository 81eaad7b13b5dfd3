// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CROSSINGS_H
#define HTLOOPS_CROSSINGS_H

#include "solve/changeable_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htloops {

/// Pairs of faces, by numbers, that meet elsewhere than in what they share.
using Crossings = std::vector<std::array<std::uint32_t, 2>>;

/// all of a mesh, in ascending order; decided exactly. Faces without area are left out. Near linear
/// in the size of the mesh and the number of crossings.
Crossings crossings_of(const Changeable_mesh& mesh);

/// those of faces that are still there, by their new numbers.
Crossings kept_crossings(const Crossings& before, const Changed_mesh& changed);

} // namespace htloops

#endif // HTLOOPS_CROSSINGS_H
