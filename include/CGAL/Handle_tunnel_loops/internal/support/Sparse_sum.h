// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SPARSE_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SPARSE_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Adds up numbers by index, few of which get any: in constant time each, and in memory for the
/// largest index. To be used again and again.
template <typename Number> class Sparse_sum
{
public:
  void add(Index i, Number number) {
    if(i >= numbers_.size())
      numbers_.resize(i + std::size_t(1), 0);
    if(numbers_[i] == 0)
      indices_.push_back(i);
    numbers_[i] += number;
  }

  /// calls `f(i, sum)` for the sums that are not zero, in ascending order of the indices, and
  /// begins again from zero.
  template <typename Function> void take(const Function& f) {
    for(Index i : indices_)
      if(const Number sum = std::exchange(numbers_[i], 0); sum != 0)
        sums_.emplace_back(i, sum);
    indices_.clear();
    std::sort(sums_.begin(), sums_.end());
    for(const auto& [i, sum] : sums_)
      f(i, sum);
    sums_.clear();
  }

private:
  std::vector<Number> numbers_; // by index
  std::vector<Index> indices_;  // of those that are not zero, each once or more, and others
  std::vector<std::pair<Index, Number>> sums_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SPARSE_SUM_H
