// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DUPLICATE_FACES_H
#define HTLOOPS_DUPLICATE_FACES_H

#include "read/soup.h"

#include <cstdint>
#include <vector>

namespace htloops {

/// Triangles with the same three vertices as another one, where edges have too many faces or faces
/// that run the same way. Both lists are sorted.
struct Duplicate_faces
{
  std::vector<std::uint32_t> duplicates; ///< all but the first of their kind

  /// A flap is a piece of a surface folded onto itself: each of its faces is there once in each
  /// orientation, and where it is fixed to others the surface is closed without it. So it is not
  /// needed at all, and leaving one side of it would leave a boundary.
  std::vector<std::uint32_t> of_flaps;
};

Duplicate_faces find_duplicate_faces(const Soup& soup);

} // namespace htloops

#endif // HTLOOPS_DUPLICATE_FACES_H
