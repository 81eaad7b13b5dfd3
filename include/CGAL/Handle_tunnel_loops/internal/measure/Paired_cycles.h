// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PAIRED_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PAIRED_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Which loop, or pair of loops, each of some cycles belongs to: it is linked with it, or with a loop
of the pair. Loop 2 k and loop 2 k + 1 are pair k.

In the order of the cycles, each takes the shortest loop that leaves to the others what they need:
of a largest matching none is lost. Those that are left over in the end take what is.
*/
class Paired_cycles
{
public:
  /// \p group is how many loops count as one: 1 or 2.
  Paired_cycles(const std::vector<const Linking_row*>& rows,
                const std::vector<double>& lengths,
                Index group)
      : candidates_(rows.size())
      , pair_of_(rows.size(), no_index)
      , cycle_of_(lengths.size() / group, no_index)
      , is_fixed_(lengths.size() / group, 0)
      , is_tried_(lengths.size() / group, 0) {
    for(std::size_t c = 0; c < rows.size(); ++c) {
      Linking_row row = *rows[c];
      std::stable_sort(row.begin(), row.end(), [&](const auto& a, const auto& b) {
        return lengths[a.first] < lengths[b.first];
      });
      for(const auto& entry : row)
        candidates_[c].push_back(entry.first / group);
    }
    match();
  }

  /// by cycle; `no_index` if there are fewer than cycles.
  const std::vector<Index>& partners() const { return pair_of_; }

private:
  void match() {
    for(Index c = 0; c < candidates_.size(); ++c)
      augment_from(c);
    for(Index c = 0; c < candidates_.size(); ++c)
      if(pair_of_[c] != no_index)
        take_best(c);
    Index free = 0;
    for(Index& pair : pair_of_)
      if(pair == no_index) {
        while(free < cycle_of_.size() && cycle_of_[free] != no_index)
          ++free;
        if(free < cycle_of_.size())
          pair = free++;
      }
  }

  bool augment_from(Index cycle) {
    std::fill(is_tried_.begin(), is_tried_.end(), 0);
    return augment(cycle);
  }

  bool augment(Index cycle) {
    for(Index pair : candidates_[cycle])
      if(is_tried_[pair] == 0 && is_fixed_[pair] == 0) {
        is_tried_[pair] = 1;
        if(cycle_of_[pair] == no_index || augment(cycle_of_[pair])) {
          assign(cycle, pair);
          return true;
        }
      }
    return false;
  }

  void assign(Index cycle, Index pair) {
    pair_of_[cycle] = pair;
    cycle_of_[pair] = cycle;
  }

  void take_best(Index cycle) {
    for(Index pair : candidates_[cycle]) {
      const Index own = pair_of_[cycle], other = cycle_of_[pair];
      if(is_fixed_[pair] != 0)
        continue;
      is_fixed_[pair] = 1;
      if(own == pair)
        return;
      cycle_of_[own] = no_index;
      assign(cycle, pair);
      if(other == no_index)
        return;
      pair_of_[other] = no_index;
      if(augment_from(other))
        return;
      assign(other, pair);
      assign(cycle, own);
      is_fixed_[pair] = 0;
    }
  }

  std::vector<std::vector<Index>> candidates_; // by cycle, pairs, the best first
  std::vector<Index> pair_of_, cycle_of_;
  std::vector<char> is_fixed_, is_tried_; // by pair
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PAIRED_CYCLES_H
