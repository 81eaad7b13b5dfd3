// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_EMPTINESS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_EMPTINESS_H

#include "Field.h"

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// whether no point is inside a solid. What it is too tedious to be sure of is not empty.
bool is_empty(const Field& field);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_EMPTINESS_H
