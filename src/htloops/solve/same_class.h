// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Which closed curves on a surface are homologous.

#ifndef HTLOOPS_SAME_CLASS_H
#define HTLOOPS_SAME_CLASS_H

#include "mesh_types.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace htloops {

/// the numbers of those pairs of loops on the surface that are not homologous over the integers, as
/// they are directed. A surface may have a boundary. Time: that of a walk over the faces, and for
/// each pair over the pieces into which all loops cut the surface.
std::vector<std::size_t>
pairs_of_different_class(const Mesh& mesh,
                         const std::vector<std::pair<const Loop*, const Loop*>>& pairs);

} // namespace htloops

#endif // HTLOOPS_SAME_CLASS_H
