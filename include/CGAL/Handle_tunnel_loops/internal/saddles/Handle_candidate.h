// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_HANDLE_CANDIDATE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_HANDLE_CANDIDATE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Two different contours meet at a saddle: a handle. `loop` is the shorter of the two, just below
/// the saddle, with the earlier side on its left.
struct Handle_candidate
{
  Crossing_loop loop;
  Index saddle;
  Index foot_a, foot_b; ///< earlier neighbours of the saddle, within either contour
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_HANDLE_CANDIDATE_H
