// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_POSITION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_POSITION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/core.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// An edge of a walk, and the place of that edge in the sequence of all walks.
struct Edge_position
{
  std::uint64_t key;
  std::size_t position;

  bool operator<(const Edge_position& p) const {
    return key != p.key ? key < p.key : position < p.position;
  }
};

CGAL_HTL_CORE void sort_positions(Execution execution, std::vector<Edge_position>& positions);

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_position_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_POSITION_H
