// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_WAY_OF_REMOVAL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_WAY_OF_REMOVAL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// How a region is laid along the loops of a handle.
struct Way_of_removal
{
  enum Style {
    STRIP,            ///< the faces at a loop, and some rings more
    BESIDE_LEFT,      ///< those at a loop some rings beside it
    BESIDE_RIGHT,     ///< ... on its other side
    SUBDIVIDED_STRIP, ///< the faces at a loop after a subdivision
    WHOLE,            ///< the faces at both loops, and some rings more
    KNOB              ///< the same, of a handle that sits on the surface like a knob on a lid
  };
  Style style;
  std::size_t choice; ///< the loop
  int rings;

  /// whether its caps lie at the loop.
  bool is_at_loop() const { return style == STRIP || style == SUBDIVIDED_STRIP; }

  bool takes_both_loops() const { return style == WHOLE || style == KNOB; }

  /// whether it takes as many faces as there is room for.
  bool fits_into_room() const { return !takes_both_loops() && style != SUBDIVIDED_STRIP; }
};

/// all ways along the loops that are allowed, the first one first. All that is along one of the two
/// loops of a handle comes before what is along the other one; of other loops, the likely ways
/// along each come first.
inline std::vector<Way_of_removal> ways_of_removal(const Removal_task& task) {
  using Way = Way_of_removal;
  std::vector<std::size_t> allowed;
  for(std::size_t i = 0; i < task.choices.size(); ++i)
    if(task.choices[i].is_allowed)
      allowed.push_back(i);
  const bool are_both_allowed = task.has_both_loops() && allowed.size() == 2;
  std::vector<Way> ways;
  if(are_both_allowed)
    ways.push_back({Way::KNOB, 0, 8});
  for(std::size_t i : allowed)
    ways.insert(ways.end(), {{Way::STRIP, i, 3},
                             {Way::STRIP, i, 0},
                             {Way::BESIDE_LEFT, i, 4},
                             {Way::BESIDE_RIGHT, i, 4}});
  if(!task.has_both_loops())
    std::stable_partition(ways.begin(), ways.end(),
                          [](const Way& way) { return way.style == Way::STRIP && way.rings > 0; });
  if(are_both_allowed)
    for(int rings : {0, 1, 2, 4, 8, 12})
      ways.push_back({Way::WHOLE, 0, rings});
  for(std::size_t i : allowed)
    ways.push_back({Way::SUBDIVIDED_STRIP, i, 0});
  return ways;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_WAY_OF_REMOVAL_H
