// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONT_MEETING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONT_MEETING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// Two fronts have met: a handle. `loop` is the shorter of the two, with what was covered on the
/// left.
struct Front_meeting
{
  Crossing_loop loop;
  Index saddle;           ///< the vertex at which they met
  Index foot_a, foot_b;   ///< covered neighbors of the saddle, behind either front
  std::vector<char> area; ///< the vertices that any layer but the base had come to
};

/// where the base layer has eroded.
template <typename Values> std::vector<char> area_of(const Values& covered) {
  std::vector<char> area(static_cast<std::size_t>(covered.size()));
  for(std::size_t v = 0; v < area.size(); ++v)
    area[v] = covered[v] > 0.;
  return area;
}

/// a front on the line on which the field has the value of the threshold.
template <typename Values> Crossing_loop placed(Crossing_loop loop, const Values& covered) {
  for(Crossing& c : loop) {
    const double drop = covered[c.left] - covered[c.right];
    const double ratio = drop > 0. ? (covered[c.left] - threshold) / drop : 0.5;
    c.ratio = (std::min)(0.99, (std::max)(0.01, ratio));
  }
  return loop;
}

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONT_MEETING_H
