// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FACE_GLUING_H
#define HTLOOPS_FACE_GLUING_H

#include "mend/mended_soup.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace htloops {

/// for each halfedge of a soup of triangles the one of the neighboring face, or `no_halfedge`.
using Neighbors = std::vector<std::uint32_t>;

constexpr std::uint32_t no_halfedge = static_cast<std::uint32_t>(-1);

/// decides which faces are neighbors, and turns faces so that neighbors agree: as few as possible
/// of each piece. Nothing, and no face is turned, if a piece is not orientable.
std::optional<Neighbors> glue_faces(Mended_soup& mended);

} // namespace htloops

#endif // HTLOOPS_FACE_GLUING_H
