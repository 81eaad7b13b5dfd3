// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_EDGE_DIVISION_H
#define HTLOOPS_EDGE_DIVISION_H

#include "mend/face_gluing.h"
#include "mend/mended_soup.h"

namespace htloops {

/// divides edges in the middle that join the same two vertices as another one: of those the first
/// stays. Fans must have vertices of their own.
void divide_parallel_edges(Mended_soup& mended, Neighbors& neighbors);

} // namespace htloops

#endif // HTLOOPS_EDGE_DIVISION_H
