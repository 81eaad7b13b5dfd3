// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_PLAN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_PLAN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// How much is spent on the search for one loop.
struct Search_effort
{
  double spacing;     ///< of the places to search from, over the length that is looked for
  std::size_t visits; ///< at most; 0: do not search
};

/*!
Divides visits of vertices among searches. What a search is expected to take is known: a disc with
half the length of the loop as radius, from each place along its partner. The cheap ones come first
and get what they need; the others share what is left, from places that are farther apart, or are
left out.
*/
class Search_plan
{
public:
  /// \p discs and \p places by search: vertices in the disc around a place, and the length of the
  /// partner over that of the loop.
  Search_plan(std::vector<double> discs, std::vector<double> places, double visits)
      : efforts_(discs.size(), {closest, 0}) {
    // Lengths may be as small as numbers get.
    for(double& disc : discs)
      disc = std::clamp(disc, 1., 1e12);
    for(double& number : places)
      number = std::clamp(number, 0., 1e6);
    std::vector<Index> order(discs.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto expected = [&](Index i) { return discs[i] * (1. + places[i] / closest); };
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return expected(a) < expected(b); });
    double planned = 0.;
    for(std::size_t n = 0; n < order.size(); ++n) {
      const Index i = order[n];
      const double share = (visits - planned) / double(order.size() - n);
      const double spacing =
          (std::max)(closest, places[i] / (std::max)(share / discs[i] - 1., 0.1 * places[i]));
      is_tight_ = is_tight_ || spacing > closest;
      if(spacing > farthest)
        continue;
      efforts_[i] = {spacing,
                     static_cast<std::size_t>(discs[i] * (1. + places[i] / spacing)) + 200};
      planned += double(efforts_[i].visits);
    }
  }

  /// whether there is nothing to search.
  bool is_empty() const {
    return std::none_of(efforts_.begin(), efforts_.end(),
                        [](const Search_effort& e) { return e.visits > 0; });
  }

  /// whether there was not enough for all.
  bool is_tight() const { return is_tight_; }

  const Search_effort& effort(std::size_t i) const { return efforts_[i]; }

private:
  static constexpr double closest = 0.1, farthest = 1.;

  std::vector<Search_effort> efforts_;
  bool is_tight_ = false;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_PLAN_H
