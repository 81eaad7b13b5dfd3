// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LOWER_LINK_COMPONENTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LOWER_LINK_COMPONENTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A maximal run of lower vertices around a saddle, by its ends: positions in the ring,
/// counterclockwise.
struct Lower_component
{
  Index first, last;
};

using Lower_link_components = boost::container::small_vector<Lower_component, 4>;

/// the lower components of a ring that has lower and higher vertices; `is_lower` is asked about
/// positions.
template <typename IsLower>
Lower_link_components find_lower_components(Ring ring, const IsLower& is_lower) {
  Index start = 0;
  while(is_lower(start) || !is_lower(ring.next(start))) {
    ++start; // a higher vertex before a lower one
    CGAL_precondition_msg(start < ring.size(), "some vertices are lower and some are higher");
  }
  Lower_link_components lower_components;
  Index p = start;
  do {
    const Index q = ring.next(p);
    if(!is_lower(p) && is_lower(q))
      lower_components.push_back({q, q});
    else if(is_lower(q))
      lower_components.back().last = q;
    p = q;
  } while(p != start);
  return lower_components;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LOWER_LINK_COMPONENTS_H
