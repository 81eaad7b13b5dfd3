// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_COMPONENT_SIZES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_COMPONENT_SIZES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// How many elements a component has.
struct Component_size
{
  std::size_t vertices = 0, halfedges = 0;

  /// V - E + F = 2 - 2 g, with 2 E = 3 F.
  std::size_t genus() const { return (2 + halfedges / 6 - vertices) / 2; }
};

/// the sizes of all components.
inline std::vector<Component_size> component_sizes(const Cut_problem& problem) {
  std::vector<Component_size> sizes(problem.mesh.seeds.size());
  for(Index v = 0; v < problem.mesh.number_of_vertices(); ++v) {
    Component_size& size = sizes[problem.mesh.component[v]];
    ++size.vertices;
    size.halfedges += problem.halfedges.end(v) - problem.halfedges.begin(v);
  }
  return sizes;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_COMPONENT_SIZES_H
