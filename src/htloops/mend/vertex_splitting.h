// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERTEX_SPLITTING_H
#define HTLOOPS_VERTEX_SPLITTING_H

#include "mend/face_gluing.h"
#include "mend/mended_soup.h"

namespace htloops {

/// gives each fan of faces, from neighbor to neighbor, a vertex of its own: the first keeps the one
/// that there is. Neighbors must agree.
void split_vertices(Mended_soup& mended, const Neighbors& neighbors);

} // namespace htloops

#endif // HTLOOPS_VERTEX_SPLITTING_H
