// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SPREAD_PROPERTIES_H
#define HTLOOPS_SPREAD_PROPERTIES_H

#include "mesh_types.h"

namespace htloops {

/// completes properties that are known for the first vertices: each further one gets the mean of
/// its neighbours that have a value, in turn from those beside the known ones.
void spread_properties(const Mesh& mesh, Vertex_properties& properties);

} // namespace htloops

#endif // HTLOOPS_SPREAD_PROPERTIES_H
