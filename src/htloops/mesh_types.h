// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_TYPES_H
#define HTLOOPS_MESH_TYPES_H

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace htloops {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// whether a point is somewhere.
inline bool is_finite(const Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

using Pair = CGAL::Handle_tunnel_pair<Mesh>;
using Loop = Pair::Loop;
using Pairs = std::vector<Pair>;

/// Both kinds, in the order in which they are written.
constexpr CGAL::Loop_type loop_types[] = {CGAL::Loop_type::HANDLE, CGAL::Loop_type::TUNNEL};

/// calls `visit(loop, type, index of the pair)` for all loops.
template <typename Visit> void for_each_loop(const Pairs& pairs, Visit visit) {
  for(std::size_t i = 0; i < pairs.size(); ++i)
    for(const CGAL::Loop_type type : loop_types)
      visit(pairs[i].loop(type), type, i);
}

/// the word for a kind, as it stands in files and messages.
inline const char* name_of(CGAL::Loop_type type) {
  return type == CGAL::Loop_type::HANDLE   ? "handle"
         : type == CGAL::Loop_type::TUNNEL ? "tunnel"
                                           : "boundary";
}

} // namespace htloops

#endif // HTLOOPS_MESH_TYPES_H
