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

#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Shorter_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
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
      , shorter_sum_(execution, mesh) {}

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
    const Common_vertex common = common_left_end(loop, by);
    for(const bool forward : {true, false})
      if(std::optional<Crossing_loop> sum = shorter_sum_.find(loop, by, common, forward, threshold))
      {
        loop = std::move(*sum);
        return true;
      }
    return false;
  }

  // There is one, because the loops cross.
  static Common_vertex common_left_end(const Crossing_loop& a, const Crossing_loop& b) {
    std::vector<std::pair<Index, std::size_t>> sorted;
    for(std::size_t j = 0; j < b.size(); ++j)
      sorted.emplace_back(b[j].left, j);
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t i = 0; i < a.size(); ++i) {
      const auto it =
          std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(a[i].left, std::size_t(0)));
      if(it != sorted.end() && it->first == a[i].left)
        return {i, it->second, &Crossing::left, &Crossing::left};
    }
    CGAL_assertion_msg(false, "loops that cross have a left end in common");
    return {};
  }

  const Flat_mesh& mesh_;
  Shorter_sum shorter_sum_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_GAUSS_REDUCTION_H
