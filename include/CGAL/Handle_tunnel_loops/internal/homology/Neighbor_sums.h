// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_NEIGHBOR_SUMS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_NEIGHBOR_SUMS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Shorter_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Shorter sums of a loop with one beside it, forwards or backwards: the step of a lattice reduction,
with the lengths that sums have once they are tightened.

A search goes from places along a partner through all that lies around; a sum costs no more than
the two loops, however long they are. It finds nothing that is far from all loops there are.
*/
class Neighbor_sums
{
public:
  /// \p lengths are those of the loops.
  Neighbor_sums(Execution execution,
                const Flat_mesh& mesh,
                const std::vector<Crossing_loop>& loops,
                const Crossing_index& index,
                const std::vector<double>& lengths)
      : loops_(loops)
      , index_(index)
      , lengths_(lengths)
      , shorter_sum_(execution, mesh) {}

  /// the sums of loop `i` with loops that are no longer and of which \p is_wanted, as far as the
  /// work, in crossings, goes, from which what they take is subtracted.
  template <typename Predicate>
  std::vector<Crossing_loop> of(Index i, double& work, const Predicate& is_wanted) {
    std::vector<Crossing_loop> sums;
    for(const Neighbor& n : neighbors(i, is_wanted)) {
      if(work <= 0.)
        break;
      const double gain =
          (std::max)(part_of_loop * lengths_[i], part_of_neighbor * lengths_[n.loop]);
      for(const bool forward : {true, false})
        if(std::optional<Crossing_loop> sum = shorter_sum_.find(loops_[i], loops_[n.loop], n.common,
                                                                forward, lengths_[i] - gain, work))
          sums.push_back(std::move(*sum));
    }
    return sums;
  }

private:
  // What a sum gains at least: less may be lost again as soon as either loop changes.
  static constexpr double part_of_loop = 0.002, part_of_neighbor = 0.05;
  static constexpr std::size_t most_neighbors = 32;

  struct Neighbor
  {
    Index loop = no_index;
    std::size_t number = 0; // of places where it is
    Common_vertex common = {};
  };

  // Those that have vertices beside loop `i` on one side or the other, most of them first.
  template <typename Predicate>
  std::vector<Neighbor> neighbors(Index i, const Predicate& is_wanted) const {
    std::map<Index, Neighbor> found;
    for(std::size_t at = 0; at < loops_[i].size(); ++at)
      for(const Crossing_end end : {&Crossing::left, &Crossing::right}) {
        const Index v = loops_[i][at].*end;
        if(at > 0 && loops_[i][at - 1].*end == v)
          continue;
        for(Index e = index_.begins()[v]; e != index_.begins()[v + 1]; ++e) {
          const Crossing_entry& entry = index_.entries()[e];
          if(entry.loop == i || lengths_[entry.loop] > lengths_[i] || !is_wanted(entry.loop))
            continue;
          Neighbor& n = found[entry.loop];
          if(n.number++ == 0)
            n = {entry.loop, 1, common_vertex(v, at, end, entry)};
        }
      }
    std::vector<Neighbor> all;
    for(const auto& entry : found)
      all.push_back(entry.second);
    std::stable_sort(all.begin(), all.end(),
                     [](const Neighbor& a, const Neighbor& b) { return a.number > b.number; });
    all.resize((std::min)(all.size(), most_neighbors));
    return all;
  }

  Common_vertex
  common_vertex(Index v, std::size_t at, Crossing_end end, const Crossing_entry& entry) const {
    const Crossing_loop& other = loops_[entry.loop];
    const Crossing_end other_end = entry.sign == 1 ? &Crossing::left : &Crossing::right;
    const auto place = std::find_if(other.begin(), other.end(),
                                    [&](const Crossing& c) { return c.*other_end == v; });
    CGAL_assertion(place != other.end());
    return {at, static_cast<std::size_t>(place - other.begin()), end, other_end};
  }

  const std::vector<Crossing_loop>& loops_;
  const Crossing_index& index_;
  const std::vector<double>& lengths_; // by loop
  Shorter_sum shorter_sum_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_NEIGHBOR_SUMS_H
