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

/// Pairs of faces, by numbers.
using Pairs_of_faces = std::vector<std::array<std::uint32_t, 2>>;

/// Faces that meet elsewhere than in what they share, in ascending order.
struct Crossings
{
  Pairs_of_faces crossing;
  /// in vertices or edges at the same place only, which are not the same, as where a surface that
  /// was no manifold has been split.
  Pairs_of_faces touching;
};

/// those of a mesh; decided exactly. Faces without area are left out. Near linear in the size of
/// the mesh and the number of pairs.
Crossings crossings_of(const Changeable_mesh& mesh);

/// those of faces of a copy that are still there, by their numbers in what it has become.
Crossings kept_crossings(const Crossings& before, const Changed_mesh& changed);

} // namespace htloops

#endif // HTLOOPS_CROSSINGS_H
