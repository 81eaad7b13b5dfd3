// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/solid/put_into_own_frame.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Own_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Own_numbering.h>

#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

std::shared_ptr<const Own_frame> put_into_own_frame(Execution execution,
                                                    Flat_mesh& mesh,
                                                    std::vector<Vector>& places,
                                                    Uninitialized_vector<Index>& order) {
  auto frame = std::make_shared<const Own_frame>(mesh, places);
  for_each_index(execution, places.size(),
                 [&](std::size_t v) { mesh.points[v] = frame->into(places[v]); });
  mesh.half_scale = frame->length_out_of(0.5);
  const Own_numbering numbering(execution, mesh);
  numbering.apply(mesh);
  numbering.apply(places);
  order = numbering.order();
  return frame;
}

} // namespace CGAL::Handle_tunnel_loops::internal
