// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_PUT_INTO_OWN_FRAME_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_PUT_INTO_OWN_FRAME_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

class Own_frame;

/// numbers the vertices of a mesh anew, and puts it into its own frame. \p places are those of the
/// vertices, hubs included, as the caller has them; they are sorted as well. \p order receives, by
/// new number, the one before.
std::shared_ptr<const Own_frame> put_into_own_frame(Execution execution,
                                                    Flat_mesh& mesh,
                                                    std::vector<Vector>& places,
                                                    Uninitialized_vector<Index>& order);

/// the same for a `Prepared_surface`.
template <typename Prepared>
std::shared_ptr<const Own_frame>
put_into_own_frame(Execution execution, Prepared& surface, std::vector<Vector>& places) {
  Uninitialized_vector<Index> order;
  auto frame = put_into_own_frame(execution, surface.mesh, places, order);
  auto sorted = surface.vertices;
  for(std::size_t v = 0; v < sorted.size(); ++v)
    sorted[v] = surface.vertices[order[v]];
  surface.vertices = std::move(sorted);
  return frame;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_PUT_INTO_OWN_FRAME_H
