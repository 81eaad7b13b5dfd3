// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/cutting/shortest_walk_beside.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the length of the shortest of the walks of `places_of_shortest_walk_beside()` that pass the
/// given end of the first place, and the walk.
static std::pair<double, std::vector<Index>> shortest_walk_from_end(
    const std::vector<Edge_ends>& places, const Length_of_edge& length, std::size_t first) {
  const auto cost = [&](Index u, Index v) { return u == v ? 0. : length(u, v); };
  const double infinite = (std::numeric_limits<double>::max)();
  std::array<double, 2> sum = {infinite, infinite};
  sum[first] = 0.;
  std::vector<std::array<unsigned char, 2>> previous(places.size() + 1);
  for(std::size_t i = 1; i <= places.size(); ++i) {
    const Edge_ends &from = places[i - 1], &to = places[i == places.size() ? 0 : i];
    std::array<double, 2> next;
    for(int b : {0, 1}) {
      const double by_0 = sum[0] + cost(from[0], to[b]), by_1 = sum[1] + cost(from[1], to[b]);
      previous[i][b] = by_1 < by_0;
      next[b] = by_1 < by_0 ? by_1 : by_0;
    }
    sum = next;
  }
  std::vector<Index> walk(places.size());
  std::size_t end = first;
  for(std::size_t i = places.size(); i > 0; --i) {
    end = previous[i][end];
    walk[i - 1] = places[i - 1][end];
  }
  return {sum[first], std::move(walk)};
}

std::vector<Index> places_of_shortest_walk_beside(const std::vector<Edge_ends>& places,
                                                  const Length_of_edge& length) {
  if(places.empty())
    return {};
  auto best = shortest_walk_from_end(places, length, 0);
  if(places.front()[0] != places.front()[1]) {
    auto other = shortest_walk_from_end(places, length, 1);
    if(other.first < best.first)
      best = std::move(other);
  }
  return std::move(best.second);
}

std::vector<Index> shortest_walk_beside(const std::vector<Edge_ends>& places,
                                        const Length_of_edge& length) {
  std::vector<Index> walk = places_of_shortest_walk_beside(places, length);
  remove_spurs(walk);
  return walk;
}

} // namespace CGAL::Handle_tunnel_loops::internal
