// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_RANGE_PARTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_RANGE_PARTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A range of any kind, say the faces of a mesh, cut into parts that threads can go through at the
/// same time. The iterators may be slow to advance, as those of a list, or of a mesh with removed
/// elements: nothing is gone through twice.
template <typename Iterator> class Range_parts
{
public:
  template <typename Range>
  explicit Range_parts(const Range& range, std::size_t part_size = 4096)
      : size_(static_cast<std::size_t>(std::distance(range.begin(), range.end()))) {
    CGAL_precondition(part_size > 0);
    Iterator it = range.begin();
    bounds_.push_back(it);
    for(std::size_t left = size_; left > 0;) {
      const std::size_t step = (std::min)(left, part_size);
      std::advance(it, static_cast<std::ptrdiff_t>(step));
      bounds_.push_back(it);
      left -= step;
    }
  }

  /// the number of elements.
  std::size_t size() const { return size_; }

  std::size_t number_of_parts() const { return bounds_.size() - 1; }

  /// calls `f(i, begin, end)` for each part i.
  template <typename Function> void for_each_part(Execution execution, const Function& f) const {
    for_each_index(
        execution, number_of_parts(), [&](std::size_t i) { f(i, bounds_[i], bounds_[i + 1]); }, 1);
  }

  /// calls `f(x)` for each element x.
  template <typename Function> void for_each(Execution execution, const Function& f) const {
    for_each_part(execution, [&](std::size_t, Iterator begin, Iterator end) {
      for(; begin != end; ++begin)
        f(*begin);
    });
  }

private:
  std::size_t size_;
  std::vector<Iterator> bounds_; // where the parts begin, and the end
};

template <typename Range> auto parts_of(const Range& range) {
  return Range_parts<std::decay_t<decltype(range.begin())>>(range);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_RANGE_PARTS_H
