// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORTED_BOXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORTED_BOXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Finds those of many boxes that meet a given one, in whatever order they come: a `Box_tree` of
/// boxes along a space-filling curve. None is empty.
template <std::size_t d> class Sorted_boxes
{
public:
  using Box = internal::Box<d>;

  Sorted_boxes(Execution execution, const std::vector<Box>& boxes)
      : order_(order(execution, boxes))
      , tree_(in_order(boxes, order_)) {}

  /// calls `f(i, b)` for each box b, with number i, that meets `box`.
  template <typename Function> void for_each_meeting(const Box& box, const Function& f) const {
    tree_.for_each_meeting(box, [&](Index i, const Box& b) { f(order_[i], b); });
  }

  /// whether `f(i, b)` holds for any of these; ends with the first.
  template <typename Predicate> bool any_meeting(const Box& box, const Predicate& f) const {
    return tree_.any_meeting(box, [&](Index i, const Box& b) { return f(order_[i], b); });
  }

private:
  static Uninitialized_vector<Index> order(Execution execution, const std::vector<Box>& boxes) {
    Box all = Box::empty();
    for(const Box& box : boxes)
      all.extend(box);
    return space_filling_order(execution, boxes.size(), [&](std::size_t i) {
      Vector place = {0., 0., 0.};
      for(std::size_t k = 0; k < (std::min)(d, place.size()); ++k)
        place[k] = all.part(k, boxes[i].low[k]);
      return place;
    });
  }

  static std::vector<Box> in_order(const std::vector<Box>& boxes,
                                   const Uninitialized_vector<Index>& order) {
    std::vector<Box> sorted;
    sorted.reserve(boxes.size());
    for(const Index i : order)
      sorted.push_back(boxes[i]);
    return sorted;
  }

  Uninitialized_vector<Index> order_;
  Box_tree<d> tree_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORTED_BOXES_H
