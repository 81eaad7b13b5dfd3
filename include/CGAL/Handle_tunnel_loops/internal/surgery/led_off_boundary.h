// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LED_OFF_BOUNDARY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LED_OFF_BOUNDARY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Leads closed walks around vertices on the boundary, from neighbour to neighbour on the surface.
class Way_off_boundary
{
public:
  explicit Way_off_boundary(const Surgery_mesh& mesh)
      : mesh_(mesh) {}

  Closed_walk around_all(const Closed_walk& walk) const {
    Closed_walk result;
    for(std::size_t i = 0; i < walk.size(); ++i)
      if(mesh_.is_on_boundary(walk[i]))
        append_around(walk[i], walk[i == 0 ? walk.size() - 1 : i - 1], after(walk, i), result);
      else
        result.push_back(walk[i]);
    remove_spurs(result);
    return result;
  }

private:
  // The neighbours strictly between two of them.
  void append_around(Index v, Index from, Index to, Closed_walk& walk) const {
    const std::vector<Index> neighbors = neighbors_on_surface(v);
    const auto begin = std::find(neighbors.begin(), neighbors.end(), from),
               end = std::find(neighbors.begin(), neighbors.end(), to);
    if(begin < end)
      walk.insert(walk.end(), begin + 1, end);
    else if(end < begin)
      walk.insert(walk.end(), std::make_reverse_iterator(begin),
                  std::make_reverse_iterator(end + 1));
  }

  // From one on the boundary to the other.
  std::vector<Index> neighbors_on_surface(Index v) const {
    std::vector<Index> neighbors;
    mesh_.for_each_outgoing(v, [&](Index h) { neighbors.push_back(mesh_.target(h)); });
    const auto hub = std::find_if(neighbors.begin(), neighbors.end(),
                                  [this](Index u) { return mesh_.is_hub(u); });
    std::rotate(neighbors.begin(), hub, neighbors.end());
    neighbors.erase(neighbors.begin());
    return neighbors;
  }

  const Surgery_mesh& mesh_;
};

/// a homotopic walk beside the boundary where the given one comes to it; or that one, where the
/// surface is too narrow.
inline Closed_walk led_off_boundary(const Surgery_mesh& mesh, const Closed_walk& walk) {
  constexpr int most_rounds = 4; // where faces have all their corners on the boundary
  Closed_walk inner = walk;
  for(int round = 0; round < most_rounds && is_on_boundary(mesh, inner); ++round) {
    inner = Way_off_boundary(mesh).around_all(inner);
    if(inner.size() < 3 || !is_intact(mesh, inner))
      return walk;
  }
  return inner;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LED_OFF_BOUNDARY_H
