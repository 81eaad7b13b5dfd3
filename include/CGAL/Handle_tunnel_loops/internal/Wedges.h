// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_WEDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_WEDGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Flat_mesh.h>

#include <boost/container/small_vector.hpp>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A maximal run of lower vertices around a saddle, by its ends: positions in the ring,
/// counterclockwise.
struct Wedge
{
  Index first, last;
};

using Wedges = boost::container::small_vector<Wedge, 4>;

/// the wedges of a ring that has lower and higher vertices; `is_lower` is asked about positions.
template <typename IsLower> Wedges find_wedges(Ring ring, const IsLower& is_lower) {
  Index start = 0;
  while(is_lower(start) || !is_lower(ring.next(start)))
    ++start; // a higher vertex before a lower one
  Wedges wedges;
  Index p = start;
  do {
    const Index q = ring.next(p);
    if(!is_lower(p) && is_lower(q))
      wedges.push_back({q, q});
    else if(is_lower(q))
      wedges.back().last = q;
    p = q;
  } while(p != start);
  return wedges;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_WEDGES_H
