// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LOOPS_ACROSS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LOOPS_ACROSS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// a loop as a closed walk on the edges, by its vertices. A loop passes an edge to a hub at its
/// other end.
inline std::vector<Index> walk_beside(const Flat_mesh& mesh, const Crossing_loop& loop) {
  std::vector<Index> walk;
  for(const Crossing& c : loop)
    if(const Index v = mesh.is_hub(c.left) ? c.right : c.left; walk.empty() || walk.back() != v)
      walk.push_back(v);
  while(walk.size() > 1 && walk.front() == walk.back())
    walk.pop_back();
  return walk;
}

/// Loops of pairs, of which some lead around inside, or across. On the walls of a cavity the solid
/// is outside, and with a boundary it is where the normals do not look: then loops of both kinds
/// are taken.
inline std::vector<const Crossing_loop*> loops_inside(const Flat_mesh& mesh,
                                                      const std::vector<Flat_pair>& pairs,
                                                      Crossing_loop Flat_pair::*kind) {
  std::vector<const Crossing_loop*> loops;
  for(const Flat_pair& pair : pairs) {
    loops.push_back(&(pair.*kind));
    if(mesh.seeds.size() > 1 || mesh.number_of_hubs > 0)
      loops.push_back(&(kind == &Flat_pair::handle ? pair.tunnel : pair.handle));
  }
  return loops;
}

/// The loops of pairs that lead around inside, of which the curtains tell cycles of the solid from
/// each other.
struct Loops_across
{
  std::vector<std::vector<Vector>> loops; ///< those of a component one after the other
  std::vector<Index> components;          ///< by loop
  std::vector<std::size_t> genus;         ///< by component: each pair is of one

  Loops_across(const Flat_mesh& mesh,
               Span<const Vector> points,
               const std::vector<Flat_pair>& pairs)
      : genus(mesh.seeds.size(), 0) {
    const auto component = [&](const Crossing_loop* loop) {
      return mesh.component[loop->front().left];
    };
    std::vector<const Crossing_loop*> across = loops_inside(mesh, pairs, &Flat_pair::handle);
    std::stable_sort(across.begin(), across.end(),
                     [&](const Crossing_loop* a, const Crossing_loop* b) {
                       return component(a) < component(b);
                     });
    for(const Crossing_loop* loop : across) {
      components.push_back(component(loop));
      loops.emplace_back();
      for(const Index v : walk_beside(mesh, *loop))
        loops.back().push_back(points[v]);
    }
    for(const Flat_pair& pair : pairs)
      ++genus[component(&pair.handle)];
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LOOPS_ACROSS_H
