// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_CROSSING_NUMBERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_CROSSING_NUMBERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// Intersection numbers with the loops of a family. A loop counts one on each edge that it crosses
/// from left to right, minus one in the other direction; the sum along a closed walk on the edges
/// is the number of times, with sign, that they cross.
class Crossing_numbers
{
public:
  Crossing_numbers(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : mesh_(mesh)
      , number_of_loops_(loops.size())
      , counts_(mesh.neighbor.size()) {
    for(Index j = 0; j < loops.size(); ++j)
      for(const Crossing& c : loops[j]) {
        counts_[slot(mesh_, c.left, c.right)].emplace_back(j, 1);
        counts_[slot(mesh_, c.right, c.left)].emplace_back(j, -1);
      }
  }

  /// the number of each loop of the family with another loop.
  std::vector<int> operator()(const Crossing_loop& loop) const {
    std::vector<int> numbers(number_of_loops_, 0);
    for_each_left_edge(loop, [&](Index u, Index v) {
      for(const auto& [j, count] : counts_[slot(mesh_, u, v)])
        numbers[j] += count;
    });
    return numbers;
  }

  /// the edges that loops from number `first` up to `last`, which is excluded, cross.
  Barred_edges walls(std::size_t first, std::size_t last) const {
    Barred_edges walls(counts_.size(), 0);
    for(std::size_t i = 0; i < counts_.size(); ++i)
      for(const auto& [j, count] : counts_[i])
        if(j >= first && j < last)
          walls[i] = 1;
    return walls;
  }

private:
  const Flat_mesh& mesh_;
  std::size_t number_of_loops_;
  std::vector<std::vector<std::pair<Index, int>>> counts_; // loop and number, by slot
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_CROSSING_NUMBERS_H
