// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_CONTOUR_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_CONTOUR_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A lower component of earlier vertices around a saddle, and the arc of the contour that leaves
/// it: what `Saddle` says of them, but for the crossings of the arc, which are not kept.
struct Lower_component_arc
{
  Index first, last; ///< positions in the ring, counterclockwise
  Index foot;        ///< the first vertex
  Index left, right; ///< ends of the edge where the arc is
  Index arc_size;
  Index arrival;      ///< the lower component at which the arc arrives
  Index handle_start; ///< if the contours before this lower component and at it meet: where the
                      ///< loop begins
  Index handle_size;
};

/// The contours at a saddle as cycles of the lower components at which they arrive, when lower
/// components 0 .. step - 1 have been joined: with step 1 just below the saddle, with as many steps
/// as there are lower components just above it.
class Contour_cycles
{
public:
  CGAL_HTL_HOST_DEVICE explicit Contour_cycles(
      const Span<const Lower_component_arc>& lower_components)
      : lower_components_(lower_components) {}

  /// calls `f(at, leaving)` for the lower components at which the contour through `start` arrives,
  /// and those at which it leaves then.
  CGAL_HTL_CALLS_ANY_FUNCTION
  template <typename Function>
  CGAL_HTL_HOST_DEVICE void for_each(Index start, Index step, const Function& f) const {
    Index at = start;
    do {
      const Index leaving = target(at, step);
      f(at, leaving);
      at = lower_components_[leaving].arrival;
    } while(at != start);
  }

  /// whether the contours that arrive at two lower components are one.
  CGAL_HTL_HOST_DEVICE bool are_joined(Index a, Index b, Index step) const {
    bool has_b = false;
    for_each(a, step, [&](Index at, Index) { has_b = has_b || at == b; });
    return has_b;
  }

  /// the first of the lower components at which the contour just below the saddle arrives.
  CGAL_HTL_HOST_DEVICE Index first_of_contour(Index lower_component) const {
    Index first = lower_component;
    for_each(lower_component, 1, [&](Index at, Index) { first = at < first ? at : first; });
    return first;
  }

private:
  // The lower component at which the contour arc that arrives at a lower component leaves: each
  // step of the unfolding has exchanged two neighbours.
  CGAL_HTL_HOST_DEVICE static Index target(Index lower_component, Index step) {
    return lower_component >= step ? lower_component
                                   : (lower_component + 1 == step ? 0 : lower_component + 1);
  }

  Span<const Lower_component_arc> lower_components_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_CONTOUR_CYCLES_H
