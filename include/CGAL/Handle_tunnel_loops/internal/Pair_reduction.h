// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PAIR_REDUCTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PAIR_REDUCTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Loop_tightening.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Takes the twist out of a pair: as long as it becomes shorter by it, the longer loop is replaced by its sum
or difference with the shorter one, as in Gauss's reduction of a lattice basis in the plane. A field
counts edges; where triangles are long and thin, the way that it finds may wind around the other loop.

Adding one element of a basis to another gives a basis again, so nothing has to be checked.
*/
class Pair_reduction
{
public:
  explicit Pair_reduction(const Flat_mesh& mesh)
    : mesh_(mesh)
    , tightening_(mesh) {}

  void reduce(Crossing_loop& a, Crossing_loop& b)
  {
    Crossing_loop *shorter = &a, *longer = &b;
    do {
      if(length(mesh_, *longer) < length(mesh_, *shorter))
        std::swap(shorter, longer);
    } while(shorten(*longer, *shorter));
  }

private:
  bool shorten(Crossing_loop& loop, const Crossing_loop& by)
  {
    const double threshold = 0.99 * length(mesh_, loop);
    for(const bool forward : {true, false}) {
      Crossing_loop sum = pushed_left(mesh_, joined(left_walk(loop), left_walk(by), forward));
      if(!sum.empty() && becomes_shorter(sum, threshold)) {
        tightening_.tighten(sum);
        loop = std::move(sum);
        return true;
      }
    }
    return false;
  }

  // Tightens a few rounds at a time, as long as the threshold is in sight.
  bool becomes_shorter(Crossing_loop& loop, double threshold)
  {
    double previous = 2. * length(mesh_, loop);
    double current = 0.5 * previous;
    while(current >= threshold && current < 0.97 * previous) {
      tightening_.tighten(loop, 8);
      previous = current;
      current = length(mesh_, loop);
    }
    return current < threshold;
  }

  static std::vector<Index> left_walk(const Crossing_loop& loop)
  {
    std::vector<Index> walk;
    for(const Crossing& c : loop)
      if(walk.empty() || walk.back() != c.left)
        walk.push_back(c.left);
    return walk;
  }

  // The loops cross once, so the walks have a vertex in common. There one is followed by the other.
  static std::vector<Index> joined(std::vector<Index> walk, std::vector<Index> other, bool forward)
  {
    std::vector<Index> sorted = other;
    std::sort(sorted.begin(), sorted.end());
    const auto common = std::find_if(walk.begin(), walk.end(), [&](Index v) {
      return std::binary_search(sorted.begin(), sorted.end(), v);
    });
    if(common == walk.end())
      return {};
    if(!forward)
      std::reverse(other.begin(), other.end());
    std::rotate(other.begin(), std::find(other.begin(), other.end(), *common), other.end());
    std::rotate(walk.begin(), common, walk.end());
    walk.insert(walk.end(), other.begin(), other.end());
    remove_spurs(walk);
    return walk;
  }

  const Flat_mesh& mesh_;
  Loop_tightening tightening_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PAIR_REDUCTION_H
