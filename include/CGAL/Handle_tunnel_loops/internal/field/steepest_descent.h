// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_STEEPEST_DESCENT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_STEEPEST_DESCENT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <cfloat>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the earlier neighbour of `v` down the steepest edge, among those that are allowed; `v` itself if
/// there is none. To follow the earliest neighbour instead would drift along the longer edges, and
/// wind around the loop from which the field came.
template <typename Mesh, typename Time_of, typename Is_allowed>
CGAL_HTL_HOST_DEVICE Index
steepest_descent(const Mesh& mesh, Index v, const Time_of& time, const Is_allowed& is_allowed) {
  const Ring ring = mesh.ring(v);
  const Time own_time = time(v);
  Index next = v;
  double steepest = 0.;
  for(Index begin = 0; begin < ring.size(); begin += stencil_width) {
    Time times[stencil_width]; // asked for before any of them is looked at
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      times[i] = begin + i < ring.size() ? time(ring[begin + i]) : never;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i) {
      if(times[i] >= own_time || !is_allowed(ring[begin + i]))
        continue;
      const Index u = ring[begin + i];
      const double drop = own_time - times[i], distance = mesh.edge_length(u, v);
      const double slope = distance > 0. ? drop / distance : DBL_MAX;
      if(slope > steepest) {
        steepest = slope;
        next = u;
      }
    }
  }
  return next;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_STEEPEST_DESCENT_H
