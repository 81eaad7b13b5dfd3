// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FACE_DROPPING_H
#define HTLOOPS_FACE_DROPPING_H

#include "mend/mended_soup.h"

namespace htloops {

/// takes out corners that name the vertex before them again, and faces of which no three are left.
void drop_degenerate_faces(Mended_soup& mended);

/// takes out triangles with the same three vertices as an earlier one, in whatever order, where
/// they are too many for their edges or run the same way. Two that close each other off stay.
void drop_duplicate_faces(Mended_soup& mended);

} // namespace htloops

#endif // HTLOOPS_FACE_DROPPING_H
