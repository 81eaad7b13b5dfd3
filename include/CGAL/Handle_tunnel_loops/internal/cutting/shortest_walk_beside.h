// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_WALK_BESIDE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_WALK_BESIDE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <array>
#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The ends of an edge on which a loop has a place; twice the same where that is a vertex.
using Edge_ends = std::array<Index, 2>;

using Length_of_edge = std::function<double(Index, Index)>;

/*!
Finds the shortest closed walk among those that pass, for each place of a loop in order, one end of
its edge. Two places on a face move to two of its corners, which are equal or joined by an edge: so
each of these walks is homotopic to the loop. Which end is the better one depends on the ends taken
before and after it: a dynamic program over the two ends, once for each end of the first place.

`length(u, v)` is the length of the edge between two vertices. Returns the vertices of the walk, a
place each: those of consecutive places may be the same.
*/
std::vector<Index> places_of_shortest_walk_beside(const std::vector<Edge_ends>& places,
                                                  const Length_of_edge& length);

/// the same walk without spurs.
std::vector<Index> shortest_walk_beside(const std::vector<Edge_ends>& places,
                                        const Length_of_edge& length);

/// the places of a loop on a mesh, whose vertices have the numbers `number(v)`.
template <typename Loop, typename TriangleMesh, typename Number>
std::vector<Edge_ends> ends_beside(const Loop& loop, const TriangleMesh& tm, const Number& number) {
  std::vector<Edge_ends> places;
  for(const auto& step : loop.steps()) {
    const Index u = number(source(step.halfedge, tm)), v = number(target(step.halfedge, tm));
    places.push_back({step.ratio == 1. ? v : u, step.ratio == 0. ? u : v});
  }
  return places;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_SHORTEST_WALK_BESIDE_H
