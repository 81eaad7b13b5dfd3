// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_ARRIVAL_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_ARRIVAL_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The total order in which the field reached the vertices; ties are broken by number.
class Arrival_order
{
public:
  explicit Arrival_order(const std::vector<Time>& time)
      : time_(&time) {}

  bool is_earlier(Index u, Index v) const {
    return arrival_key((*time_)[u], u) < arrival_key((*time_)[v], v);
  }

  Time time(Index v) const { return (*time_)[v]; }

  Index earliest_neighbor(const Flat_mesh& mesh, Index v) const {
    const Ring ring = mesh.ring(v);
    CGAL_precondition(ring.size() != 0);
    return *std::min_element(ring.begin(), ring.end(),
                             [this](Index a, Index b) { return is_earlier(a, b); });
  }

private:
  const std::vector<Time>* time_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_ARRIVAL_ORDER_H
