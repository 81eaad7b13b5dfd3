// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A loop passes an edge, with one end of it to the left and the other to the right. The place is
/// `left + ratio * (right - left)`; a loop that goes through a vertex passes the edges on one side
/// of it at ratio 0 or 1. The place is geometry; the class of the loop rests on the ends alone.
/// Edges to hubs of caps are passed at their other end, whatever the ratio says.
struct Crossing
{
  Index left;
  Index right;
  double ratio;
};

/// A closed curve as the cyclic sequence of the edges it passes. Consecutive edges belong to one
/// triangle, hence share an end: the left ends are a closed walk on the edges that is homotopic to
/// the loop, and so are the right ends.
using Crossing_loop = std::vector<Crossing>;

/// A pair of loops in the terms of the flat mesh.
struct Flat_pair
{
  Crossing_loop handle, tunnel;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_H
