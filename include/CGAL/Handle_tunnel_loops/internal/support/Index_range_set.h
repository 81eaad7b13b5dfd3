// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_RANGE_SET_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_RANGE_SET_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A set that is asked far more often than it has elements: a bit for each index from the least to
/// the greatest one.
class Index_range_set
{
public:
  /// of indices in ascending order.
  explicit Index_range_set(const std::vector<Index>& indices)
      : first_(indices.empty() ? 0 : indices.front())
      , bits_(indices.empty() ? 0 : indices.back() - first_ + 1) {
    for(Index i : indices)
      bits_[i - first_] = true;
  }

  bool contains(Index i) const { return i - first_ < bits_.size() && bits_[i - first_]; }

private:
  Index first_;
  std::vector<bool> bits_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_RANGE_SET_H
