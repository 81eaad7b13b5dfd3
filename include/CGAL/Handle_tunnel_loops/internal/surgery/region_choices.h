// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Region_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// all regions along the loops that are allowed, the first one first, given the order of these.
/// What leaves most of the shape alone comes first: before things are taken out whole, strips may
/// cross what the surface has crossed. What seldom helps is not for loops nearby. That which is
/// known to do comes before all.
inline std::vector<Region_choice> region_choices(const Removal_task& task,
                                                 const std::vector<std::size_t>& allowed) {
  using Choice = Region_choice;
  const bool are_both_allowed = task.has_both_loops() && allowed.size() == 2;
  std::vector<Choice> all;
  if(are_both_allowed)
    all.push_back({Choice::KNOB, allowed.front(), 8});
  for(std::size_t i : allowed)
    if(task.are_types_known && task.choices[i].type == Loop_type::TUNNEL)
      for(int rings : {1, 0})
        all.push_back({Choice::BORE, i, rings});
  for(std::size_t i : allowed)
    all.push_back({Choice::STRIP, i, 0});
  for(std::size_t i : allowed)
    for(int rings : {3, 0})
      if(rings > 0 || !task.are_loops_nearby())
        all.push_back({Choice::RINGS, i, rings});
  if(!task.are_loops_nearby())
    for(std::size_t i : allowed)
      all.push_back({Choice::STRIP, i, 0, true});
  if(are_both_allowed)
    for(int rings : {0, 1, 2, 3, 4, 6, 10})
      all.push_back({Choice::WHOLE, allowed.front(), rings});
  if(are_both_allowed)
    for(int rings : {0, 1, 2})
      all.push_back({Choice::WHOLE, allowed.front(), rings, true});
  if(task.region)
    if(const auto known = std::find(all.begin(), all.end(), *task.region); known != all.end())
      std::rotate(all.begin(), known, known + 1);
  return all;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICES_H
