// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATING_STRIPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATING_STRIPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Concurrent_disjoint_sets.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/surface_count.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Which of some strips, that share no vertices, would separate the surface if they were taken out
/// and closed in this order, but for those that would. Near linear in the size of the mesh, however
/// many strips there are.
inline std::vector<char> separating_strips(Execution execution,
                                           const Surgery_mesh& mesh,
                                           const std::vector<const Cut_region*>& strips) {
  std::vector<char> is_taken_out(mesh.face_bound(), 0);
  for(const Cut_region* strip : strips)
    for(Index f : strip->faces())
      is_taken_out[f] = 1;
  Concurrent_disjoint_sets left =
      pieces(execution, mesh, [&](Index f) { return mesh.is_alive(f) && !is_taken_out[f]; });
  // The last ones that are needed to join what is left stay.
  std::vector<char> separates(strips.size(), 0);
  for(std::size_t i = strips.size(); i-- > 0;) {
    const auto beyond = [&](std::size_t border) {
      return mesh.face(mesh.twin(strips[i]->border(border).front()));
    };
    separates[i] = left.root(beyond(0)) != left.root(beyond(1));
    left.unite(beyond(0), beyond(1));
  }
  return separates;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATING_STRIPS_H
