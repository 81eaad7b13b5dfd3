// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_STARS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_STARS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Front_mean.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

enum class Vertex_kind : Index { MINIMUM, REGULAR, SADDLE, MAXIMUM };

/// What the sweep needs to know of a vertex; gathered beforehand, because the sweep jumps through
/// memory and this does not.
struct Star
{
  Front_mean change; ///< of the front when it passes the vertex
  Index below;       ///< the slot, at a lower neighbour, of the edge to it; none at a minimum
  Vertex_kind kind;
};

/// the slot of the edge from `u` to its neighbour `v`, among those of `u`.
inline Index slot_of(const Flat_mesh& mesh, Index u, Index v) {
  const Index position = mesh.position(u, v);
  CGAL_precondition_msg(position < mesh.ring(u).size(), "they are neighbours");
  return mesh.row_begin[u] + position;
}

inline Star star_of(const Flat_mesh& mesh, const Sweep_order& order, Index v) {
  const Ring ring = mesh.ring(v);
  const Index rank = order.rank(v);
  Star star = {{}, no_index, Vertex_kind::REGULAR};
  bool is_previous_lower = order.rank(ring[ring.size() - 1]) < rank;
  Index number_of_changes = 0;
  for(Index p = 0; p < ring.size(); ++p) {
    const bool is_lower = order.rank(ring[p]) < rank;
    if(is_lower) {
      star.change -= crossing_of_front(mesh, v, ring, p);
      if(star.below == no_index)
        star.below = slot_of(mesh, ring[p], v);
    } else
      star.change += crossing_of_front(mesh, v, ring, p);
    number_of_changes += is_lower != is_previous_lower;
    is_previous_lower = is_lower;
  }
  star.kind = number_of_changes > 2    ? Vertex_kind::SADDLE
              : number_of_changes == 2 ? Vertex_kind::REGULAR
              : star.below == no_index ? Vertex_kind::MINIMUM
                                       : Vertex_kind::MAXIMUM;
  return star;
}

inline std::vector<Star>
sweep_stars(Execution execution, const Flat_mesh& mesh, const Sweep_order& order) {
  std::vector<Star> stars(mesh.number_of_vertices());
  for_each_index(execution, stars.size(),
                 [&](std::size_t v) { stars[v] = star_of(mesh, order, static_cast<Index>(v)); });
  return stars;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_STARS_H
