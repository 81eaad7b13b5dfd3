// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How a region is laid along the loops of a handle.
struct Region_choice
{
  enum Style {
    KNOB,  ///< the faces at both loops, and some rings more, of a handle that sits on the surface
           ///< like a knob on a lid
    BORE,  ///< the wall of a bore that the loop goes around; with rings, and of bores that it
           ///< meets, if it does
    STRIP, ///< a narrow strip along the loop
    RINGS, ///< the faces at the loop, and some rings more
    WHOLE  ///< the faces at both loops, and some rings more
  };
  Style style;
  std::size_t loop; ///< the number of its choice
  int rings;
  bool may_cross = false; ///< whether caps may cross what the surface there crosses

  bool takes_both_loops() const { return style == WHOLE || style == KNOB; }
  bool is_along_curve() const { return style == STRIP || style == BORE; }
};

/// all regions along the loops that are allowed, the first one first, given the order of these.
/// What leaves most of the shape alone comes first.
inline std::vector<Region_choice> region_choices(const Removal_task& task,
                                                 const std::vector<std::size_t>& allowed) {
  using Choice = Region_choice;
  const bool are_both_allowed = task.has_both_loops() && allowed.size() == 2;
  std::vector<Choice> all;
  if(are_both_allowed)
    all.push_back({Choice::KNOB, allowed.front(), 8});
  for(std::size_t i : allowed)
    if(!task.are_types_known || task.choices[i].type == Loop_type::TUNNEL)
      for(int rings : {1, 0})
        all.push_back({Choice::BORE, i, rings});
  for(std::size_t i : allowed)
    all.push_back({Choice::STRIP, i, 0});
  for(std::size_t i : allowed)
    for(int rings : {3, 0})
      all.push_back({Choice::RINGS, i, rings});
  if(are_both_allowed)
    for(int rings : {0, 1, 2, 3, 4, 5, 6, 8, 10, 12})
      all.push_back({Choice::WHOLE, allowed.front(), rings});
  for(std::size_t i : allowed)
    all.push_back({Choice::STRIP, i, 0, true});
  if(are_both_allowed)
    for(int rings : {0, 1, 2})
      all.push_back({Choice::WHOLE, allowed.front(), rings, true});
  return all;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICE_H
