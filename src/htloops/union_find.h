// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_UNION_FIND_H
#define HTLOOPS_UNION_FIND_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace htloops {

/// Disjoint sets of the numbers from 0 to a size.
class Union_find
{
public:
  explicit Union_find(std::size_t size)
      : parents_(size) {
    std::iota(parents_.begin(), parents_.end(), std::uint32_t(0));
  }

  /// the representative of the set of `i`.
  std::uint32_t find(std::uint32_t i) {
    while(parents_[i] != i)
      i = parents_[i] = parents_[parents_[i]];
    return i;
  }

  bool is_representative(std::uint32_t i) const { return parents_[i] == i; }

  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    // The smaller number represents: chains stay short where numbers that meet are close.
    if(i < j)
      parents_[j] = i;
    else
      parents_[i] = j;
  }

private:
  std::vector<std::uint32_t> parents_;
};

} // namespace htloops

#endif // HTLOOPS_UNION_FIND_H
