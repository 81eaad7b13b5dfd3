// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_SHORTER_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_SHORTER_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A vertex that two loops have in common: which crossing of each has it at which end.
struct Common_vertex
{
  std::size_t at_first, at_second;
  Crossing_end first_end, second_end;
};

/// One loop followed by another, forwards or backwards, tightened if there is a chance that it
/// becomes short.
class Shorter_sum
{
public:
  Shorter_sum(Execution execution, const Flat_mesh& mesh)
      : mesh_(mesh)
      , tightening_(execution, mesh) {}

  /// the sum if it is shorter than the threshold.
  std::optional<Crossing_loop> find(const Crossing_loop& a,
                                    const Crossing_loop& b,
                                    const Common_vertex& common,
                                    bool forward,
                                    double threshold) {
    return shorter(pushed_left(mesh_, joined(a, b, common, forward)), threshold);
  }

  /// the same, unless the sum is led around a hub, so that it crosses many times as many edges as
  /// both loops, or to find out takes more than what is left of the work, in crossings. What it
  /// takes at least is subtracted.
  std::optional<Crossing_loop> find(const Crossing_loop& a,
                                    const Crossing_loop& b,
                                    const Common_vertex& common,
                                    bool forward,
                                    double threshold,
                                    double& work) {
    Crossing_loop sum = pushed_left(mesh_, joined(a, b, common, forward));
    const bool is_around_hub = sum.size() > most_growth * (a.size() + b.size());
    work -= is_around_hub ? double(sum.size()) : double(least_rounds) * double(sum.size());
    return is_around_hub || work < 0. ? std::nullopt : shorter(std::move(sum), threshold);
  }

private:
  static constexpr std::size_t least_rounds = 8, most_growth = 4;

  std::optional<Crossing_loop> shorter(Crossing_loop sum, double threshold) {
    if(sum.empty() || !becomes_shorter(sum, threshold))
      return std::nullopt;
    tightening_.tighten(sum);
    return sum;
  }

  // As a walk along their ends.
  static std::vector<Index> joined(const Crossing_loop& a,
                                   const Crossing_loop& b,
                                   const Common_vertex& common,
                                   bool forward) {
    const auto [i, j, a_end, b_end] = common;
    std::vector<Index> walk;
    for(std::size_t k = 0; k < a.size(); ++k)
      walk.push_back(a[(i + k) % a.size()].*a_end);
    for(std::size_t k = 0; k < b.size(); ++k)
      walk.push_back(b[(forward ? j + k : j + b.size() - k) % b.size()].*b_end);
    remove_spurs(walk);
    return walk;
  }

  // Tightens some rounds at a time, as long as the threshold is in sight. A loop that loses a twist
  // does so from the first rounds on: soon there is less left to gain than has been gained.
  bool becomes_shorter(Crossing_loop& loop, double threshold) {
    const double first = length(mesh_, loop);
    const std::size_t most_work = tightening_.share_of_work();
    const std::size_t rounds =
        (std::max)(least_rounds, (std::min)(loop.size() / 64, most_work / loop.size()));
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

  const Flat_mesh& mesh_;
  Loop_tightening tightening_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_SHORTER_SUM_H
