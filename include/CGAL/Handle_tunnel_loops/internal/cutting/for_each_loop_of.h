// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_FOR_EACH_LOOP_OF_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_FOR_EACH_LOOP_OF_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>

namespace CGAL::Handle_tunnel_loops::internal {

/// Calls `f` for both loops of a pair, or for a single loop.
template <typename TriangleMesh, typename Point, typename Function>
void for_each_loop_of(const Handle_tunnel_pair<TriangleMesh, Point>& pair, const Function& f) {
  f(pair.handle());
  f(pair.tunnel());
}
template <typename Loop, typename Function>
void for_each_loop_of(const Loop& loop, const Function& f) {
  f(loop);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_FOR_EACH_LOOP_OF_H
