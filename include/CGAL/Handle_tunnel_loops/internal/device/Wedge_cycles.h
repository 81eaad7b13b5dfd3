// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WEDGE_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WEDGE_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Span.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// A wedge of earlier vertices around a saddle, and the arc of the contour that leaves it: what
/// `Saddle` says of them, but for the crossings of the arc, which are not kept.
struct Wedge
{
  Index first, last; ///< positions in the ring, counterclockwise
  Index foot;        ///< the first vertex
  Index left, right; ///< ends of the edge where the arc is
  Index arc_size;
  Index arrival;      ///< the wedge at which the arc arrives
  Index handle_start; ///< if the contours before this wedge and at it meet: where the loop begins
  Index handle_size;
};

/// The contours at a saddle as cycles of the wedges at which they arrive, when wedges
/// 0 .. step - 1 have been joined: with step 1 just below the saddle, with as many steps as there
/// are wedges just above it.
class Wedge_cycles
{
public:
  CGAL_HTL_HOST_DEVICE explicit Wedge_cycles(const Span<const Wedge>& wedges)
      : wedges_(wedges) {}

  /// calls `f(at, leaving)` for the wedges at which the contour through `start` arrives, and those
  /// at which it leaves then.
  CGAL_HTL_CALLS_ANY_FUNCTION
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void for_each(Index start, Index step, const Function& f) const {
    Index at = start;
    do {
      const Index leaving = target(at, step);
      f(at, leaving);
      at = wedges_[leaving].arrival;
    } while(at != start);
  }

  /// whether the contours that arrive at two wedges are one.
  CGAL_HTL_HOST_DEVICE bool are_joined(Index a, Index b, Index step) const {
    bool has_b = false;
    for_each(a, step, [&](Index at, Index) { has_b = has_b || at == b; });
    return has_b;
  }

  /// the first of the wedges at which the contour just below the saddle arrives.
  CGAL_HTL_HOST_DEVICE Index first_of_contour(Index wedge) const {
    Index first = wedge;
    for_each(wedge, 1, [&](Index at, Index) { first = at < first ? at : first; });
    return first;
  }

private:
  // The wedge at which the strand that arrives at a wedge leaves: each step of the unfolding has
  // exchanged two neighbours.
  CGAL_HTL_HOST_DEVICE static Index target(Index wedge, Index step) {
    return wedge >= step ? wedge : (wedge + 1 == step ? 0 : wedge + 1);
  }

  Span<const Wedge> wedges_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WEDGE_CYCLES_H
