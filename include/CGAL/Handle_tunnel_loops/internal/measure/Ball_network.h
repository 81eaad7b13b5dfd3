// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_BALL_NETWORK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_BALL_NETWORK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Balls, and straight ways between their centers along which smaller ones fit.
struct Ball_network
{
  struct Node
  {
    Vector place;
    double radius;
  };

  struct Edge
  {
    std::array<Index, 2> nodes;
    float radius; ///< the least along the edge, rounded
    float seen;   ///< the same as far as the surface is known
  };

  std::vector<Node> nodes;
  std::vector<Edge> edges;

  /// the point of an edge that is nearest to the points that the balls of both its ends pass.
  Vector narrowest(Index edge) const {
    const Node &a = nodes[edges[edge].nodes[0]], &b = nodes[edges[edge].nodes[1]];
    const Vector way = b.place - a.place;
    const double square = dot(way, way);
    const double ratio =
        square > 0. ? 0.5 * (square + (a.radius - b.radius) * (a.radius + b.radius)) / square : 0.;
    return a.place + (std::max)(0., (std::min)(1., ratio)) * way;
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_BALL_NETWORK_H
