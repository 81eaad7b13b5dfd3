// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_SHORTEST_WALK_BESIDE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_SHORTEST_WALK_BESIDE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The ends of an edge on which a loop has a place; twice the same where that is a vertex.
using Edge_ends = std::array<Index, 2>;

/*!
Finds the shortest closed walk among those that pass, for each place of a loop in order, one end of
its edge. Two places on a face move to two of its corners, which are equal or joined by an edge: so
each of these walks is homotopic to the loop. Which end is the better one depends on the ends taken
before and after it: a dynamic program over the two ends, once for each end of the first place.
*/
template <typename Length> class Walk_beside
{
public:
  /// `length(u, v)` is the length of the edge between two vertices.
  Walk_beside(const std::vector<Edge_ends>& places, const Length& length)
      : places_(places)
      , length_(length) {}

  /// the vertices of the walk, a place each: those of consecutive places may be the same.
  std::vector<Index> find() const {
    if(places_.empty())
      return {};
    auto best = from_end(0);
    if(places_.front()[0] != places_.front()[1]) {
      auto other = from_end(1);
      if(other.first < best.first)
        best = std::move(other);
    }
    return std::move(best.second);
  }

private:
  double cost(Index u, Index v) const { return u == v ? 0. : length_(u, v); }

  // The length of the best walk that passes the given end of the first place, and the walk.
  std::pair<double, std::vector<Index>> from_end(std::size_t first) const {
    const double infinite = (std::numeric_limits<double>::max)();
    std::array<double, 2> sum = {infinite, infinite};
    sum[first] = 0.;
    std::vector<std::array<unsigned char, 2>> previous(places_.size() + 1);
    for(std::size_t i = 1; i <= places_.size(); ++i) {
      const Edge_ends &from = places_[i - 1], &to = places_[i == places_.size() ? 0 : i];
      std::array<double, 2> next;
      for(int b : {0, 1}) {
        const double by_0 = sum[0] + cost(from[0], to[b]), by_1 = sum[1] + cost(from[1], to[b]);
        previous[i][b] = by_1 < by_0;
        next[b] = by_1 < by_0 ? by_1 : by_0;
      }
      sum = next;
    }
    std::vector<Index> walk(places_.size());
    std::size_t end = first;
    for(std::size_t i = places_.size(); i > 0; --i) {
      end = previous[i][end];
      walk[i - 1] = places_[i - 1][end];
    }
    return {sum[first], std::move(walk)};
  }

  const std::vector<Edge_ends>& places_;
  const Length& length_;
};

/// the shortest closed walk beside the places of a loop, see `Walk_beside`.
template <typename Length>
std::vector<Index> shortest_walk_beside(const std::vector<Edge_ends>& places,
                                        const Length& length) {
  return Walk_beside<Length>(places, length).find();
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_SHORTEST_WALK_BESIDE_H
