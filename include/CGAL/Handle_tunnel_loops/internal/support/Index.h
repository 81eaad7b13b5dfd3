// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The number of a vertex, a loop, a cell.
using Index = std::uint32_t;
constexpr Index no_index = (std::numeric_limits<Index>::max)();

/// As many neighbours as rows of a fixed length have room for: valences vary at random, and a
/// mispredicted branch costs as much as the work itself.
constexpr Index stencil_width = 8;

/// the same number for both directions of an edge, by the numbers of its ends.
constexpr std::uint64_t edge_key(std::uint64_t u, std::uint64_t v) {
  return u < v ? u << 32 | v : v << 32 | u;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_H
