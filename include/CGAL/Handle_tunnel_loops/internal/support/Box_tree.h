// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_BOX_TREE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_BOX_TREE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An axis-parallel box of dimension d, its boundary included.
template <std::size_t d> struct Box
{
  std::array<double, d> low, high;

  /// the box that holds nothing.
  static Box empty() {
    constexpr double infinite = (std::numeric_limits<double>::infinity)();
    Box box;
    box.low.fill(infinite);
    box.high.fill(-infinite);
    return box;
  }

  /// where a coordinate lies between the sides of the box: from 0 to 1.
  double part(std::size_t i, double x) const {
    const double width = half_difference(high[i], low[i]);
    return width > 0. ? (std::min)(half_difference(x, low[i]) / width, 1.) : 0.;
  }

  bool meets(const Box& b) const {
    bool is_apart = false; // without branches, which can't be foretold
    for(std::size_t i = 0; i < d; ++i)
      is_apart |= (low[i] > b.high[i]) | (b.low[i] > high[i]);
    return !is_apart;
  }
  void extend(const Box& b) {
    for(std::size_t i = 0; i < d; ++i) {
      low[i] = (std::min)(low[i], b.low[i]);
      high[i] = (std::max)(high[i], b.high[i]);
    }
  }
};

/// Finds those of many boxes that meet a given one. The boxes are grouped in the order in which
/// they come, so that neighbours in that order should be neighbours in space.
template <std::size_t d> class Box_tree
{
public:
  using Box = internal::Box<d>;

  explicit Box_tree(std::vector<Box> boxes)
      : levels_(1, std::move(boxes)) {
    while(levels_.back().size() > 1)
      levels_.push_back(unions_of_groups(levels_.back()));
  }

  std::size_t size() const { return levels_.front().size(); }

  const Box& box(std::size_t i) const { return levels_.front()[i]; }

  /// calls `f(i, b)` for each box b, with number i, that meets `box`.
  template <typename Function> void for_each_meeting(const Box& box, const Function& f) const {
    any_meeting(box, [&](Index i, const Box& b) {
      f(i, b);
      return false;
    });
  }

  /// whether `f(i, b)` holds for any of these; ends with the first.
  template <typename Predicate> bool any_meeting(const Box& box, const Predicate& f) const {
    return any_meeting_from(0, box, f);
  }

  /// the same for the boxes with number `first` or more.
  template <typename Predicate>
  bool any_meeting_from(std::size_t first, const Box& box, const Predicate& f) const {
    std::size_t step = 1; // between the first leaves of the children of the root
    for(std::size_t level = 2; level < levels_.size(); ++level)
      step *= group_size;
    return !levels_.front().empty() && levels_.back().front().meets(box) &&
           visit({first, box}, levels_.size() - 1, 0, step, f);
  }

  /// whether any box meets `box`.
  bool is_any_meeting(const Box& box) const {
    return any_meeting(box, [](Index, const Box&) { return true; });
  }

private:
  static constexpr std::size_t group_size = 4;

  static std::vector<Box> unions_of_groups(const std::vector<Box>& boxes) {
    std::vector<Box> groups;
    groups.reserve(boxes.size() / group_size + 1);
    for(std::size_t i = 0; i < boxes.size(); ++i)
      if(i % group_size == 0)
        groups.push_back(boxes[i]);
      else
        groups.back().extend(boxes[i]);
    return groups;
  }

  struct Query
  {
    std::size_t first;
    const Box& box;
  };

  // Of a node that meets the box; the first leaves of its children are so many apart.
  template <typename Predicate>
  bool visit(const Query& query,
             std::size_t level,
             std::size_t i,
             std::size_t step,
             const Predicate& f) const {
    if(level == 0)
      return i >= query.first && f(static_cast<Index>(i), levels_[0][i]);
    const std::vector<Box>& below = levels_[level - 1];
    const std::size_t end = (std::min)((i + 1) * group_size, below.size());
    for(std::size_t child = (std::max)(i * group_size, query.first / step); child < end; ++child)
      if(below[child].meets(query.box) && visit(query, level - 1, child, step / group_size, f))
        return true;
    return false;
  }

  std::vector<std::vector<Box>> levels_; // the boxes, their groups, the groups of these, ...
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_BOX_TREE_H
