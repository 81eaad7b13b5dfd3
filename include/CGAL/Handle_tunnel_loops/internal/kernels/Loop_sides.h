// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_LOOP_SIDES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_LOOP_SIDES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Shorter_arc.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// The loops of the passes, pass after pass.
struct Loop_sides
{
  Span<const Crossing> crossings;
  Span<const Index> pass;   ///< by crossing
  Span<const Index> begin;  ///< by pass, its first crossing
  Span<const double> along; ///< by pass, one more than crossings: see `Shorter_arc`

  CGAL_HTL_HOST_DEVICE Shorter_arc way_along(Index k) const {
    const Index first = begin[k];
    return {crossings.data() + first, begin[k + 1] - first, along.data() + first + k};
  }
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_LOOP_SIDES_H
