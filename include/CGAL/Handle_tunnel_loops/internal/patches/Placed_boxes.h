// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PLACED_BOXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PLACED_BOXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/space_filling_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Finds those of many things that are near those of others, by their boxes. Things that are near
/// each other are kept in groups, each with one box: 12 bytes for each of them.
class Placed_boxes
{
public:
  Placed_boxes() = default;

  /// of numbers 0 .. n - 1; `box(i)` is the box of the i-th, which may be empty.
  template <typename Function>
  Placed_boxes(Execution execution, std::size_t n, const Function& box)
      : order_(order(execution, n, box)) {
    std::vector<Box<3>> boxes((n + group_size - 1) / group_size, Box<3>::empty());
    for_each_index(execution, boxes.size(), [&](std::size_t group) {
      for(std::size_t i = group * group_size; i < (std::min)(n, (group + 1) * group_size); ++i)
        boxes[group].extend(box(order_[i]));
    });
    tree_ = Box_tree<3>(std::move(boxes));
  }

  /// calls `f(i, j)` for those of these and of others whose boxes meet; `box(i)` and `other_box(j)`
  /// are what the boxes were made from.
  template <typename Box_of, typename Box_of_other, typename Function>
  void for_each_meeting(const Placed_boxes& others,
                        const Box_of& box,
                        const Box_of_other& other_box,
                        const Function& f) const {
    for(std::size_t other = 0; other < others.tree_.size(); ++other) {
      const Box<3>& around = others.tree_.box(other);
      tree_.for_each_meeting(around, [&](Index group, const Box<3>&) {
        for_each_of(group, [&](Index i) {
          const Box<3> b = box(i);
          if(b.meets(around))
            others.for_each_of(other, [&](Index j) {
              if(b.meets(other_box(j)))
                f(i, j);
            });
        });
      });
    }
  }

private:
  static constexpr std::size_t group_size = 8;

  template <typename Function> void for_each_of(std::size_t group, const Function& f) const {
    const std::size_t begin = group * group_size;
    for(std::size_t i = begin; i < (std::min)(order_.size(), begin + group_size); ++i)
      f(order_[i]);
  }

  template <typename Function>
  static std::vector<Index> order(Execution execution, std::size_t n, const Function& box) {
    constexpr std::size_t grain = 16384;
    std::vector<Box<3>> parts((n + grain - 1) / grain, Box<3>::empty());
    execution.for_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        parts[begin / grain].extend(box(i));
    });
    Box<3> all = Box<3>::empty();
    for(const Box<3>& part : parts)
      all.extend(part);
    // The same for all directions, so that neighbours on a flat patch are neighbours in the order.
    double size = 0.;
    for(std::size_t d = 0; d < 3; ++d)
      size = (std::max)(size, all.high[d] - all.low[d]);
    return space_filling_order(execution, n, [&](std::size_t i) {
      const Box<3> b = box(i);
      Vector place;
      for(std::size_t d = 0; d < 3; ++d) {
        const bool is_empty = b.low[d] > b.high[d];
        place[d] = size > 0. && !is_empty ? (b.low[d] - all.low[d]) / size : 0.;
      }
      return place;
    });
  }

  std::vector<Index> order_;
  Box_tree<3> tree_{std::vector<Box<3>>()};
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PLACED_BOXES_H
