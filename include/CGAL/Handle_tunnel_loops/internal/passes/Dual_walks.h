// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DUAL_WALKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DUAL_WALKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What the loop passes look for: for each of several loops walks that cross it once, see
/// `Bidirectional_front`.
struct Dual_loop_query
{
  const std::vector<Crossing_loop>& loops;
  const Crossing_index& index;                  ///< of these loops
  bool bars_only_own;                           ///< `Only_loop`, or `Loops_from`
  std::vector<Index> numbers;                   ///< of the loops to search for
  Index number_of_walks = 1;                    ///< so many are enough
  std::vector<Time> numbers_of_steps{};         ///< by loop, the most to make; or empty
  std::uint64_t number_of_updates = UINT64_MAX; ///< the most to make for each
};

/// What they find for one loop.
struct Dual_walks
{
  std::vector<std::vector<Index>> walks; ///< closed, on the edges
  bool has_given_up = false;             ///< for it needed more updates
};

/// is told how far the work has come, in [0, 1], and says whether to go on.
using Callback = std::function<bool(double)>;

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DUAL_WALKS_H
