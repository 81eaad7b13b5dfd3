// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_CAP_HUBS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_CAP_HUBS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The vertices in the middle of the caps that close a surface with boundary, by their indices;
/// none of a closed surface. Where they lie in space is no part of the surface: nothing that is
/// decided by geometry may come to them, or to the faces around them.
class Cap_hubs
{
public:
  Cap_hubs() = default;
  explicit Cap_hubs(std::vector<Index> hubs)
      : hubs_(std::move(hubs)) {
    std::sort(hubs_.begin(), hubs_.end());
  }

  /// Logarithmic in the number of hubs, and constant below the first of them.
  bool contain(Index v) const {
    return !hubs_.empty() && v >= hubs_.front() &&
           std::binary_search(hubs_.begin(), hubs_.end(), v);
  }

private:
  std::vector<Index> hubs_; // sorted
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_CAP_HUBS_H
