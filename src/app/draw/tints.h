// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TINTS_H
#define HTLOOPS_TINTS_H

#include "mesh_types.h"
#include "solve/reeb_solver.h"
#include "solve/skeleton_solver.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace htloops {

/// the colour of what has no parts, or only one.
constexpr Colour plain_tint = {238, 240, 244};

/// pale colours for so many parts of a surface, on which lines stand out: four of them, or, where
/// neighbours would have the same one, up to six. Neighbours may be named more than once.
std::vector<Colour> tints_of(std::size_t number_of_parts,
                             const std::vector<std::pair<std::size_t, std::size_t>>& neighbours);

/// those of the arcs of a Reeb graph; different also where parts only touch.
std::vector<Colour> tints_of(const Mesh& mesh, const Reeb_answer& answer);

/// those of the arcs of a skeleton, to which vertices of the mesh belong.
std::vector<Colour> tints_of(const Mesh& mesh,
                             const Skeleton_answer& answer,
                             const std::vector<std::size_t>& arcs_of_vertices);

} // namespace htloops

#endif // HTLOOPS_TINTS_H
