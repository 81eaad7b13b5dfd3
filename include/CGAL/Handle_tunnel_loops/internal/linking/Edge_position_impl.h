// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_POSITION_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_POSITION_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_position.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE void sort_positions(Execution execution, std::vector<Edge_position>& positions) {
  sort(execution, positions.begin(), positions.end(), std::less<Edge_position>());
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_POSITION_IMPL_H
