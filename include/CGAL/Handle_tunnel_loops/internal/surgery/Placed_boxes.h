// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PLACED_BOXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PLACED_BOXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/halved_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Finds those of many things that are near those of others, by their boxes. Things that are near
/// each other are kept in groups, each with one box: 12 bytes for each of them.
class Placed_boxes
{
public:
  Placed_boxes() = default;

  /// of numbers 0 .. n - 1; `box(i)` is the box of the i-th, which may be empty.
  template <typename Function>
  Placed_boxes(Execution execution, std::size_t n, const Function& box)
      : order_(halved_order<group_size>(execution, n, box)) {
    std::vector<Box<3>> boxes((n + group_size - 1) / group_size, Box<3>::empty());
    for_each_index(execution, boxes.size(), [&](std::size_t group) {
      for(std::size_t i = group * group_size; i < (std::min)(n, (group + 1) * group_size); ++i)
        boxes[group].extend(box(order_[i]));
    });
    tree_ = Box_tree<3>(std::move(boxes));
  }

  /// whether `f(i, j, done)` holds for any of these and of others whose boxes meet; so many of the
  /// others, which come in groups, are done once the group of `j` is. `box(i)` and `other_box(j)`
  /// are what the boxes were made from. Ends soon after the first.
  template <typename Box_of, typename Box_of_other, typename Predicate>
  bool any_meeting(const Placed_boxes& others,
                   const Box_of& box,
                   const Box_of_other& other_box,
                   const Predicate& f,
                   Execution execution = Execution()) const {
    std::atomic<bool> is_found(false);
    return any_group(execution, others, is_found, [&](std::size_t other) {
      const std::size_t done = (std::min)((other + 1) * group_size, others.order_.size());
      return meets_group(others, other, 0, box, other_box,
                         [&](Index i, Index j) { return is_found || f(i, j, done); });
    });
  }

  /// whether `f(i, j)` holds for any two of these whose boxes meet; asked once for each pair.
  template <typename Box_of, typename Predicate>
  bool any_pair(const Box_of& box, const Predicate& f, Execution execution = Execution()) const {
    std::atomic<bool> is_found(false);
    const auto is_pair = [&](Index i, Index j) { return is_found || f(i, j); };
    return any_group(execution, *this, is_found, [&](std::size_t group) {
      return is_any_pair_in(group, box, is_pair) ||
             meets_group(*this, group, group + 1, box, box, is_pair);
    });
  }

  /// about how many of these boxes meet one of them, on average, each weighted by `weight(i, j)`:
  /// counted for some of them, and no further than to \p bound, beyond which the answer is no exact
  /// one. The same each time.
  template <typename Box_of, typename Weight>
  double crowding(const Box_of& box, double bound, const Weight& weight) const {
    constexpr std::size_t number_of_samples = 64;
    const std::size_t step = tree_.size() / number_of_samples + 1;
    double number_of_boxes = 0., number_of_meetings = 0.;
    for(std::size_t group = 0; group < tree_.size(); group += step)
      number_of_boxes += double((std::min)(group_size, order_.size() - group * group_size));
    const auto is_above_bound = [&] { return number_of_meetings > bound * number_of_boxes; };
    for(std::size_t group = 0; group < tree_.size() && !is_above_bound(); group += step)
      meets_group(*this, group, 0, box, box, [&](Index i, Index j) {
        number_of_meetings += weight(i, j);
        return is_above_bound();
      });
    return number_of_boxes == 0. ? 0. : number_of_meetings / number_of_boxes;
  }

  /// those that meet a box.
  template <typename Box_of>
  std::vector<Index> meeting(const Box<3>& around, const Box_of& box) const {
    std::vector<Index> all;
    tree_.for_each_meeting(around, [&](Index group, const Box<3>&) {
      any_of(group, [&](Index i) {
        if(box(i).meets(around))
          all.push_back(i);
        return false;
      });
    });
    return all;
  }

private:
  static constexpr std::size_t group_size = 8;
  static constexpr std::size_t grain = 32; // groups that a thread takes at once

  // Whether it holds for any group of others, which is found then.
  template <typename Predicate>
  static bool any_group(Execution execution,
                        const Placed_boxes& others,
                        std::atomic<bool>& is_found,
                        const Predicate& holds) {
    for_each_index(
        execution, others.tree_.size(),
        [&](std::size_t group) {
          if(!is_found && holds(group))
            is_found = true;
        },
        grain);
    return is_found;
  }

  template <typename Box_of, typename Predicate>
  bool is_any_pair_in(std::size_t group, const Box_of& box, const Predicate& f) const {
    const std::size_t end = (std::min)((group + 1) * group_size, order_.size());
    for(std::size_t k = group * group_size; k < end; ++k)
      for(std::size_t l = k + 1; l < end; ++l)
        if(box(order_[k]).meets(box(order_[l])) && f(order_[k], order_[l]))
          return true;
    return false;
  }

  // Of these, groups from `first` on.
  template <typename Box_of, typename Box_of_other, typename Predicate>
  bool meets_group(const Placed_boxes& others,
                   std::size_t other,
                   std::size_t first,
                   const Box_of& box,
                   const Box_of_other& other_box,
                   const Predicate& f) const {
    const Box<3>& around = others.tree_.box(other);
    const std::size_t begin = other * group_size;
    const std::size_t number = (std::min)(group_size, others.order_.size() - begin);
    std::array<Box<3>, group_size> other_boxes;
    for(std::size_t k = 0; k < number; ++k)
      other_boxes[k] = other_box(others.order_[begin + k]);
    return tree_.any_meeting_from(first, around, [&](Index group, const Box<3>&) {
      return any_of(group, [&](Index i) {
        const Box<3> b = box(i);
        if(b.meets(around))
          for(std::size_t k = 0; k < number; ++k)
            if(b.meets(other_boxes[k]) && f(i, others.order_[begin + k]))
              return true;
        return false;
      });
    });
  }

  template <typename Predicate> bool any_of(std::size_t group, const Predicate& f) const {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(group * group_size);
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(
                                          (std::min)(order_.size(), (group + 1) * group_size));
    return std::any_of(begin, end, f);
  }

  std::vector<Index> order_;
  Box_tree<3> tree_{std::vector<Box<3>>()};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PLACED_BOXES_H
