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

/// Takes out, from a loop without backtracks, turns around a vertex, which are no way at all. Every
/// path becomes shorter by that: after a turn it is on an edge where it was before, and nearer by
/// the edge. The edges are those of a loop or of a strip. Linear.
template <typename Edge> class Turn_removal
{
public:
  Turn_removal(const Flat_mesh& mesh, std::vector<Edge>& edges)
      : mesh_(mesh)
      , edges_(edges)
      , begins_(edges.size()) {}

  void run() {
    for(const Edge& edge : edges_) {
      edges_[kept_] = edge;
      note_begins();
      drop_turn(edge.left, begins_[kept_].at_left);
      drop_turn(edge.right, begins_[kept_].at_right);
      ++kept_;
    }
    // All of it may be turns around one vertex.
    const bool is_turn =
        kept_ > 1 && (begins_[kept_ - 1].at_left == 0 || begins_[kept_ - 1].at_right == 0);
    edges_.erase(edges_.begin() + (is_turn ? 0 : kept_), edges_.end());
  }

private:
  // The first of the edges, one after the other, that end at a vertex.
  struct Begins
  {
    std::size_t at_left, at_right;
  };

  void note_begins() {
    begins_[kept_] = {kept_, kept_};
    if(kept_ > 0 && edges_[kept_].left == edges_[kept_ - 1].left)
      begins_[kept_].at_left = begins_[kept_ - 1].at_left;
    if(kept_ > 0 && edges_[kept_].right == edges_[kept_ - 1].right)
      begins_[kept_].at_right = begins_[kept_ - 1].at_right;
  }

  // If the last edge is the first one at a vertex again, it takes its place.
  void drop_turn(Index v, std::size_t first) {
    if(kept_ - first < 3 || kept_ - first < mesh_.ring(v).size())
      return;
    edges_[first] = edges_[kept_];
    kept_ = first;
    note_begins();
  }

  const Flat_mesh& mesh_;
  std::vector<Edge>& edges_;
  std::vector<Begins> begins_;
  std::size_t kept_ = 0; // edges
};

template <typename Edge> void remove_turns(const Flat_mesh& mesh, std::vector<Edge>& edges) {
  Turn_removal<Edge>(mesh, edges).run();
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_REMOVE_TURNS_H
