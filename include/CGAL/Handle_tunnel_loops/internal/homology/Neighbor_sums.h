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
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// what each loop may take of some work: as many sums for each, about, as those of long loops take
/// more.
inline std::vector<double> shares_by_size(const std::vector<Crossing_loop>& loops, double work) {
  double size = 0.;
  for(const Crossing_loop& loop : loops)
    size += double(loop.size());
  std::vector<double> shares;
  for(const Crossing_loop& loop : loops)
    shares.push_back(work / size * double(loop.size()));
  return shares;
}

/*!
Shorter sums of a loop with one beside it, forwards or backwards: the step of a lattice reduction,
with the lengths that sums have once they are tightened.

A search goes from places along a partner through all that lies around; a sum costs no more than
the two loops, however long they are. It finds nothing that is far from all loops there are.
*/
class Neighbor_sums
{
public:
  /// \p lengths are those of the loops. A workspace that can be used again.
  Neighbor_sums(Execution execution,
                const Flat_mesh& mesh,
                const std::vector<Crossing_loop>& loops,
                const Crossing_index& index,
                const std::vector<double>& lengths)
      : loops_(loops)
      , index_(index)
      , lengths_(lengths)
      , shorter_sum_(execution, mesh)
      , numbers_(loops.size(), 0) {}

  /// the sums of loop `i` with loops that are no longer and of which \p is_wanted, as far as the
  /// work, in crossings, goes, from which what they take is subtracted.
  template <typename Predicate>
  std::vector<Crossing_loop> of(Index i, double& work, const Predicate& is_wanted) {
    std::vector<Crossing_loop> sums;
    if(work <= 0.)
      return sums;
    for(const Neighbor& n : neighbors(i, is_wanted)) {
      if(work <= 0.)
        break;
      const double gain =
          (std::max)(part_of_loop * lengths_[i], part_of_neighbor * lengths_[n.loop]);
      const Common_vertex common = common_vertex(i, n);
      for(const bool forward : {true, false})
        if(std::optional<Crossing_loop> sum = shorter_sum_.find(loops_[i], loops_[n.loop], common,
                                                                forward, lengths_[i] - gain, work))
          sums.push_back(std::move(*sum));
    }
    return sums;
  }

private:
  // What a sum gains at least: less may be lost again as soon as either loop changes.
  static constexpr double part_of_loop = 0.002, part_of_neighbor = 0.05;
  // Of more than these hardly any gives a shorter one.
  static constexpr std::size_t most_neighbors = 4;

  // A loop with vertices beside loop `i` on one side or the other, and the first of these: at the
  // end of a crossing of each.
  struct Neighbor
  {
    Index loop;
    std::size_t at;
    Crossing_end end, other_end;
    std::size_t number = 0; // of places where it is
  };

  // Those that are wanted, with most places first.
  template <typename Predicate>
  std::vector<Neighbor> neighbors(Index i, const Predicate& is_wanted) {
    std::vector<Neighbor> all = loops_beside(i);
    for(Neighbor& n : all)
      n.number = std::exchange(numbers_[n.loop], 0);
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const Neighbor& n) {
                               return n.loop == i || lengths_[n.loop] > lengths_[i] ||
                                      !is_wanted(n.loop);
                             }),
              all.end());
    std::sort(all.begin(), all.end(), [](const Neighbor& a, const Neighbor& b) {
      return a.number != b.number ? a.number > b.number : a.loop < b.loop;
    });
    all.resize((std::min)(all.size(), most_neighbors));
    return all;
  }

  // Counts their places: there are very many where loops share their ways.
  std::vector<Neighbor> loops_beside(Index i) {
    std::vector<Neighbor> found;
    for(std::size_t at = 0; at < loops_[i].size(); ++at)
      for(const Crossing_end end : {&Crossing::left, &Crossing::right}) {
        const Index v = loops_[i][at].*end;
        if(at > 0 && loops_[i][at - 1].*end == v)
          continue;
        for(const Crossing_entry& entry : index_.entries_at(v))
          if(numbers_[entry.loop]++ == 0)
            found.push_back(
                {entry.loop, at, end, entry.sign == 1 ? &Crossing::left : &Crossing::right});
      }
    return found;
  }

  Common_vertex common_vertex(Index i, const Neighbor& n) const {
    const Crossing_loop& other = loops_[n.loop];
    const Index v = loops_[i][n.at].*n.end;
    const auto place = std::find_if(other.begin(), other.end(),
                                    [&](const Crossing& c) { return c.*n.other_end == v; });
    CGAL_assertion(place != other.end());
    return {n.at, static_cast<std::size_t>(place - other.begin()), n.end, n.other_end};
  }

  const std::vector<Crossing_loop>& loops_;
  const Crossing_index& index_;
  const std::vector<double>& lengths_; // by loop
  Shorter_sum shorter_sum_;
  std::vector<std::size_t> numbers_; // by loop; zero but while neighbors are counted
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_NEIGHBOR_SUMS_H
