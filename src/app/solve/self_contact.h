// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SELF_CONTACT_H
#define HTLOOPS_SELF_CONTACT_H

#include "mesh_types.h"

#include <functional>

namespace htloops {

/// whether two faces meet elsewhere than in a common vertex or edge, or a face has no area: then
/// the surface is not the boundary of a solid. Decided exactly. Takes about as long as reading the
/// mesh, unless faces are so long and thin that the boxes of most of them meet; throws
/// `Interrupted` soon after a signal.
bool touches_itself(
    const Mesh& mesh, const std::function<void()>& look = [] {});

} // namespace htloops

#endif // HTLOOPS_SELF_CONTACT_H
