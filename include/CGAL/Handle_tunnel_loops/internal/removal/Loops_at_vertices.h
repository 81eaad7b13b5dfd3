// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_AT_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_AT_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Which loops of which handles come to a vertex, or came to it before they were led elsewhere.
class Loops_at_vertices
{
public:
  /// the number of a handle, and which loop of it.
  using Loop = std::pair<std::size_t, std::size_t>;

  void add(const Loop& loop, const Closed_walk& walk) {
    for(Index v : walk) {
      const auto [begin, end] = loops_at_.equal_range(v);
      if(std::none_of(begin, end, [&](const auto& at) { return at.second == loop; }))
        loops_at_.insert({v, loop});
    }
  }

  /// in ascending order.
  std::vector<Loop> at(const std::vector<Index>& vertices) const {
    std::vector<Loop> loops;
    for(Index v : vertices)
      for(auto [it, end] = loops_at_.equal_range(v); it != end; ++it)
        loops.push_back(it->second);
    make_set(loops);
    return loops;
  }

private:
  std::unordered_multimap<Index, Loop> loops_at_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_AT_VERTICES_H
