// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_VIEW_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_VIEW_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

namespace CGAL::Handle_tunnel_loops::internal {

/// What is known of a vertex: its cell, `no_index` if it is open, and the next vertex on the way to
/// the centre, `no_index` there.
struct Cell_link
{
  Index cell, parent;
};

/// of the cells beside an open vertex for which `may_grow(cell)` holds the least, and there the
/// least neighbour. `cell_of(u)` is the cell of a vertex, `no_index` if it is in none.
template <typename Function, typename Predicate>
CGAL_HTL_HOST_DEVICE Cell_link least_link(const Ring& ring,
                                          const Function& cell_of,
                                          const Predicate& may_grow) {
  Cell_link best = {no_index, no_index};
  for(Index u : ring) {
    const Index c = cell_of(u);
    if((c < best.cell || (c == best.cell && c != no_index && u < best.parent)) && may_grow(c))
      best = {c, u};
  }
  return best;
}

/// The arrays of `Cells`, and those of their mesh, in the memory of the host or of the device.
struct Cell_view
{
  Mesh_view mesh;
  Span<const Cell_link> links;   ///< by vertex
  Span<const char> are_vertices; ///< by vertex: whether it is a cell for good, which does not grow

  CGAL_HTL_HOST_DEVICE Ring ring(Index v) const { return mesh.ring(v); }
  CGAL_HTL_HOST_DEVICE const Cell_link& operator[](Index v) const { return links[v]; }
  CGAL_HTL_HOST_DEVICE Index cell(Index v) const { return links[v].cell; }
  CGAL_HTL_HOST_DEVICE Index parent(Index v) const { return links[v].parent; }
  CGAL_HTL_HOST_DEVICE bool is_alone(Index v) const { return are_vertices[v] != 0; }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_VIEW_H
