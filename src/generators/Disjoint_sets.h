// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_DISJOINT_SETS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_DISJOINT_SETS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// The sets into which 0, ..., n - 1 are joined.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n)
      : parent_(n)
      , count_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::size_t count() const { return count_; }

  /// joins the sets of `a` and `b`; returns whether they were different.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if(a == b)
      return false;
    parent_[(std::max)(a, b)] = (std::min)(a, b);
    --count_;
    return true;
  }

private:
  std::uint32_t root(std::uint32_t v) {
    for(; parent_[v] != v; v = parent_[v])
      parent_[v] = parent_[parent_[v]];
    return v;
  }

  std::vector<std::uint32_t> parent_;
  std::size_t count_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_DISJOINT_SETS_H
