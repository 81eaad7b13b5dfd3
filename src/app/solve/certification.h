// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CERTIFICATION_H
#define HTLOOPS_CERTIFICATION_H

#include "mesh_types.h"
#include "skeleton_lines.h"
#include "solve/answer.h"

#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>

#include <functional>
#include <string>
#include <vector>

namespace htloops {

/// what loops that were found elsewhere are; on what sides they bound only `with_sides`.
Certificate certify(const Mesh& mesh, const Pairs& pairs, Basis_kind basis_kind, bool with_sides);

/// what is wrong with boundary curves and waists that were found elsewhere, in words.
std::vector<std::string> problems_of_boundaries(const Mesh& mesh,
                                                const std::vector<Loop>& curves,
                                                const std::vector<Loop>& waists);

/// whether a loop that was found elsewhere is a closed curve on the surface.
std::vector<char> are_closed_on_surface(const Mesh& mesh, const std::vector<Loop>& loops);

/// whether two faces meet elsewhere than in a common vertex or edge, or a face has no area: then
/// the surface is not the boundary of a solid. Decided exactly. Takes about as long as reading the
/// mesh, unless faces are so long and thin that the boxes of most of them meet; throws
/// `Interrupted` soon after a signal.
bool touches_itself(
    const Mesh& mesh, const std::function<void()>& look = [] {});

/// what can be proved of a skeleton, given the loops of its mesh. Components and inlets are found
/// by their places if they are not known. Throws `Interrupted` soon after a signal.
CGAL::Handle_tunnel_loops::Skeleton_certificate certify_skeleton(
    const Mesh& mesh,
    const Skeleton_lines& skeleton,
    const Pairs& pairs,
    const std::function<void()>& look = [] {});

/// whether a mesh, with the caps that close its boundary curves, touches itself; what means nothing
/// then is taken back from a certificate. Throws `Interrupted` soon after a signal.
bool note_self_contact(
    const Mesh& mesh,
    CGAL::Handle_tunnel_loops::Skeleton_certificate& certificate,
    const std::function<void()>& look = [] {});

} // namespace htloops

#endif // HTLOOPS_CERTIFICATION_H
