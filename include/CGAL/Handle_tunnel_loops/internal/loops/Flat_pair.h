// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_FLAT_PAIR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_FLAT_PAIR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A pair of loops in the terms of the flat mesh.
struct Flat_pair
{
  Crossing_loop handle, tunnel;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_FLAT_PAIR_H
