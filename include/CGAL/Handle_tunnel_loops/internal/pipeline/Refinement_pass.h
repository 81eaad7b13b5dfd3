// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_REFINEMENT_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_REFINEMENT_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Basis_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Pass_context.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// For each tunnel the way from its left side around to its right side (paper, 4.3), which becomes
/// the handle if it is shorter and the loops remain a basis. Where they would not, because the
/// tunnels of several pairs led to one handle, the next best way is tried.
class Refinement_pass
{
public:
  /// \p contours is the index of the contours that cross each tunnel as `Tunnel_pass` says.
  Refinement_pass(const Pass_context& context,
                  std::vector<Crossing_loop>& handles,
                  const std::vector<Crossing_loop>& tunnels,
                  const Crossing_index& contours)
      : context_(context)
      , handles_(handles)
      , tunnels_(tunnels)
      , index_(context.mesh, tunnels)
      , exchange_(tunnels, contours, index_)
      , candidates_(tunnels.size())
      , is_refined_(tunnels.size(), 0) {
    CGAL_precondition(handles.size() == tunnels.size());
  }

  /// refines the handles. Returns how many had to be kept although shorter ones were found.
  std::size_t run() {
    find_candidates();
    std::vector<Index> open = all_loops();
    for(std::size_t i = 0, ready = 0; i < number_of_candidates && !open.empty(); ++i) {
      if(i == ready)
        ready = tighten_candidates(open, i);
      open = replace_handles(open, i);
    }
    return open.size();
  }

  /// by handle, whether it was replaced.
  const std::vector<char>& is_refined() const { return is_refined_; }

private:
  // How many refinements of a handle are tried.
  static constexpr Index number_of_candidates = 6;

  std::vector<Index> all_loops() const {
    std::vector<Index> numbers(tunnels_.size());
    std::iota(numbers.begin(), numbers.end(), Index(0));
    return numbers;
  }

  void find_candidates() {
    Dual_loop_query query = {tunnels_, index_, true, all_loops(), number_of_candidates};
    for(const Crossing_loop& handle : handles_)
      query.numbers_of_steps.push_back(steps_along(handle));
    std::vector<Dual_walks> found = context_.dual_walks(query, 0., 0.6);
    CGAL_assertion(found.size() == handles_.size());
    context_.for_each(found.size(), [&](std::size_t k) {
      const std::vector<std::vector<Index>> walks = std::move(found[k].walks);
      for(const std::vector<Index>& walk : walks)
        candidates_[k].push_back(pushed_left(context_.mesh, walk));
    });
  }

  // A number of steps in which two fronts together go farther than the loop is long: each passes an
  // edge length in four of the largest steps, and a geodesic crosses two edges on it.
  Time steps_along(const Crossing_loop& loop) const {
    return steps_of(static_cast<Time>(16 + loop.size() * 3 / 4), context_.searching);
  }

  // Tightens candidate i of the given handles: after the first ones, which mostly do, as many of
  // the next ones as well as there are threads that have nothing else to do. Returns the first that
  // it leaves.
  std::size_t tighten_candidates(const std::vector<Index>& numbers, std::size_t i) {
    const std::size_t spare = i == 0 ? 1 : context_.execution.number_of_threads() / numbers.size();
    const std::size_t end =
        (std::min)(i + (std::max)(spare, std::size_t(1)), std::size_t(number_of_candidates));
    context_.for_each(numbers.size() * (end - i), [&](std::size_t j) {
      std::vector<Crossing_loop>& loops = candidates_[numbers[j % numbers.size()]];
      if(i + j / numbers.size() < loops.size())
        context_.tighten(loops[i + j / numbers.size()]);
    });
    return end;
  }

  // Tries candidate i of the given handles, the largest gains first. Returns the handles that had
  // to be kept although the candidate is shorter.
  std::vector<Index> replace_handles(const std::vector<Index>& numbers, std::size_t i) {
    std::vector<double> gain(candidates_.size(), 0.);
    std::vector<char> is_gain(candidates_.size(), 0);
    std::vector<std::optional<Basis_exchange::Row>> rows(candidates_.size());
    context_.for_each(numbers.size(), [&](std::size_t j) {
      const Index k = numbers[j];
      if(i >= candidates_[k].size() || !is_shorter(context_.mesh, candidates_[k][i], handles_[k]))
        return;
      is_gain[k] = 1;
      gain[k] = length(context_.mesh, handles_[k]) - length(context_.mesh, candidates_[k][i]);
      rows[k] = exchange_.handle_part(candidates_[k][i]);
    });
    std::vector<Index> order = numbers;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return gain[a] > gain[b]; });
    std::vector<Index> kept;
    for(Index k : order) {
      if(!is_gain[k])
        continue;
      is_refined_[k] = rows[k] && exchange_.accept(k, *rows[k]);
      if(is_refined_[k])
        handles_[k] = std::move(candidates_[k][i]);
      else
        kept.push_back(k);
    }
    return kept;
  }

  const Pass_context& context_;
  std::vector<Crossing_loop>& handles_;
  const std::vector<Crossing_loop>& tunnels_;
  Crossing_index index_; // of the tunnels
  Basis_exchange exchange_;
  std::vector<std::vector<Crossing_loop>> candidates_; // by tunnel
  std::vector<char> is_refined_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_REFINEMENT_PASS_H
