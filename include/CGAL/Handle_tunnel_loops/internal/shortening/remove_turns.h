// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_REMOVE_TURNS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_REMOVE_TURNS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the first crossings, one after the other, that are a turn around a vertex, as [first, end): the
/// next one would be the first again. Or all, where all of them are turns around one vertex. The
/// edges are those of a loop or of a strip.
template <typename Edge>
std::pair<std::size_t, std::size_t> first_turn(const Flat_mesh& mesh,
                                               const std::vector<Edge>& edges) {
  std::size_t first_at_left = 0, first_at_right = 0; // the first that ends where edge i does
  std::pair<std::size_t, std::size_t> turn = {edges.size(), edges.size()};
  const auto set_turn = [&](Index v, std::size_t first, std::size_t end) {
    if(end - first == edges.size())
      turn = {first, end};
    else if(end - first > 3 && end - first > mesh.ring(v).size())
      turn = {first, end - 1};
    return turn.first < turn.second;
  };
  for(std::size_t i = 1; i < edges.size(); ++i) {
    if(edges[i].left != edges[i - 1].left)
      first_at_left = i;
    if(edges[i].right != edges[i - 1].right)
      first_at_right = i;
    if(set_turn(edges[i].left, first_at_left, i + 1) ||
       set_turn(edges[i].right, first_at_right, i + 1))
      break;
  }
  return turn;
}

/// takes out, from a loop without backtracks, turns around a vertex, which are no way at all. Every
/// path becomes shorter by that: after a turn it is on an edge where it was before, and nearer by
/// the edge.
template <typename Edge> void remove_turns(const Flat_mesh& mesh, std::vector<Edge>& edges) {
  for(;;) {
    const auto [first, end] = first_turn(mesh, edges);
    if(first == end)
      return;
    edges.erase(edges.begin() + first, edges.begin() + end);
  }
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_REMOVE_TURNS_H
