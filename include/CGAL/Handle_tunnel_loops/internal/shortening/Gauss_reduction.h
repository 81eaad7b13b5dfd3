// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_GAUSS_REDUCTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_GAUSS_REDUCTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Takes the twist out of a pair: as long as it becomes shorter by it, the longer loop is replaced by
its sum or difference with the shorter one, as in Gauss's reduction of a lattice basis in the plane.
A field counts edges; where triangles are long and thin, the way that it finds may wind around the
other loop.

Adding one element of a basis to another gives a basis again, so nothing has to be checked.
*/
class Gauss_reduction
{
public:
  Gauss_reduction(Execution execution, const Flat_mesh& mesh)
      : mesh_(mesh)
      , tightening_(execution, mesh) {}

  void reduce(Crossing_loop& a, Crossing_loop& b) {
    Crossing_loop *shorter = &a, *longer = &b;
    do {
      if(is_shorter(mesh_, *longer, *shorter))
        std::swap(shorter, longer);
    } while(shorten(*longer, *shorter));
  }

private:
  bool shorten(Crossing_loop& loop, const Crossing_loop& by) {
    // Of two loops of nearly the same length, the sum is hardly ever shorter than both.
    if(length(mesh_, loop) < 1.1 * length(mesh_, by))
      return false;
    const double threshold = rounded_product(0.99, length(mesh_, loop));
    for(const bool forward : {true, false}) {
      Crossing_loop sum = pushed_left(mesh_, joined(loop, by, forward));
      if(!sum.empty() && becomes_shorter(sum, threshold)) {
        tightening_.tighten(sum);
        loop = std::move(sum);
        return true;
      }
    }
    return false;
  }

  // Tightens some rounds at a time, as long as the threshold is in sight. A loop that loses a twist
  // does so from the first rounds on: soon there is less left to gain than has been gained.
  bool becomes_shorter(Crossing_loop& loop, double threshold) {
    const double first = length(mesh_, loop);
    const std::size_t most_work = tightening_.share_of_work();
    const std::size_t rounds =
        (std::max)(std::size_t(8), (std::min)(loop.size() / 64, most_work / loop.size()));
    double before = first, most_left = 1.5;
    for(std::size_t work = 0; work < most_work; work += rounds * loop.size()) {
      tightening_.tighten(loop, rounds);
      const double now = length(mesh_, loop);
      if(now < threshold)
        return true;
      if(now - threshold > most_left * (first - now) || now > 0.99 * before)
        return false;
      before = now;
      most_left = 1.;
    }
    return false;
  }

  // Crossings with the same left end, one on each loop; there are some, because the loops cross.
  static std::pair<std::size_t, std::size_t> common_place(const Crossing_loop& a,
                                                          const Crossing_loop& b) {
    std::vector<std::pair<Index, std::size_t>> sorted;
    for(std::size_t j = 0; j < b.size(); ++j)
      sorted.emplace_back(b[j].left, j);
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t i = 0; i < a.size(); ++i) {
      const auto it =
          std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(a[i].left, std::size_t(0)));
      if(it != sorted.end() && it->first == a[i].left)
        return {i, it->second};
    }
    return {a.size(), b.size()};
  }

  // One loop followed by the other, as a walk along their left ends.
  static std::vector<Index> joined(const Crossing_loop& a, const Crossing_loop& b, bool forward) {
    const auto [i, j] = common_place(a, b);
    CGAL_assertion_msg(i < a.size() && j < b.size(), "loops that cross have a left end in common");
    std::vector<Index> walk;
    for(std::size_t k = 0; k < a.size(); ++k)
      walk.push_back(a[(i + k) % a.size()].left);
    for(std::size_t k = 0; k < b.size(); ++k)
      walk.push_back(b[(forward ? j + k : j + b.size() - k) % b.size()].left);
    remove_spurs(walk);
    return walk;
  }

  const Flat_mesh& mesh_;
  Loop_tightening tightening_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_GAUSS_REDUCTION_H
