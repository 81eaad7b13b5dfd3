// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_HANDLE_CANDIDATES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_HANDLE_CANDIDATES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/Processor_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Saddle_contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

/// the handles that the saddles of a field offer, in the order in which these are reached. Of a
/// field with one minimum they are exactly as many as the genus, because Euler's formula leaves no
/// other number.
inline std::vector<Handle_candidate>
find_handle_candidates(Execution execution, const Flat_mesh& mesh, const std::vector<Time>& times) {
  Processor_executor executor(execution);
  const Span<const Time> span(times.data(), times.size());
  return Saddle_contours<Processor_executor>(executor, view_of(mesh), span).handles();
}

/// the walk from `v` down to the source of the field, each vertex followed by its earliest
/// neighbour.
inline std::vector<Index> descent(const Flat_mesh& mesh, const Arrival_order& order, Index v) {
  std::vector<Index> walk(1, v);
  for(Index u = order.earliest_neighbor(mesh, v); order.is_earlier(u, v);
      u = order.earliest_neighbor(mesh, v))
  {
    walk.push_back(u);
    v = u;
  }
  return walk;
}

/// the tunnel of a handle that the field itself offers: from the saddle down on either side to the
/// source. It crosses its own handle once and no handle that was found later, whatever the mesh.
inline Crossing_loop descending_tunnel(const Flat_mesh& mesh,
                                       const Arrival_order& order,
                                       const Handle_candidate& handle) {
  std::vector<Index> walk = descent(mesh, order, handle.foot_a);
  std::vector<Index> other = descent(mesh, order, handle.foot_b);
  CGAL_assertion_msg(order.is_earlier(handle.foot_a, handle.saddle) &&
                         order.is_earlier(handle.foot_b, handle.saddle),
                     "the feet are below the saddle");
  CGAL_assertion_msg(walk.back() == other.back(), "both ways go down to the one source");
  walk.insert(walk.end(), other.rbegin(), other.rend());
  walk.push_back(handle.saddle);
  remove_spurs(walk);
  return pushed_left(mesh, walk);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_HANDLE_CANDIDATES_H
