// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_LOOP_PIPELINE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_LOOP_PIPELINE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Flat_pair.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Basis_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Dual_loop_query.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Voronoi_graph_search.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Host_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Dual_loop_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Gauss_reduction.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Workspace_pool.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The passes on the flat mesh, one after the other. Their fields are computed by `Passes`:
/// `Host_backend` or `Device_backend`.
template <typename Execution, typename Passes = Host_backend<Execution>> class Loop_pipeline
{
public:
  struct Options
  {
    Field_constants constants;
    Device_options device;
    bool do_refine_handles = true;
    bool do_tighten = true;
    bool do_log_fronts = false;
  };

  /// \p seeds are the vertices to start from, one in each component.
  Loop_pipeline(const Flat_mesh& mesh,
                std::vector<Index> seeds,
                const Options& options,
                Progress& progress)
      : mesh_(mesh)
      , seeds_(std::move(seeds))
      , options_(options)
      , progress_(progress) {}

  /// paper, 4.1: the arrival times of one field over the whole mesh, and the handles read off them.
  void initial_pass(Statistics& statistics) {
    progress_.start(Stage::INITIAL);
    passes_.emplace(mesh_, step_coefficients(options_.constants), options_.device);
    handle_candidates_ = passes_->sweep(seeds_, progress_);
    if(options_.do_log_fronts)
      statistics.front_events = passes_->front_log().events;
    passes_->report(statistics);
    handles_.resize(handle_candidates_.size());
    is_refined_.assign(handle_candidates_.size(), 0);
    for_each_index(
        execution_, handles_.size(),
        [&](std::size_t k) {
          handles_[k] = handle_candidates_[k].loop;
          tighten(handles_[k], few_rounds);
        },
        1);
    progress_.end(Stage::INITIAL);
  }

  /// paper, 4.2: for each handle the way from its left side around to its right side.
  void tunnel_pass(Statistics& statistics) {
    progress_.start(Stage::TUNNEL);
    std::vector<Crossing_loop> contours(handle_candidates_.size());
    for(std::size_t k = 0; k < contours.size(); ++k)
      contours[k] = std::move(handle_candidates_[k].loop);
    contour_index_ = std::make_unique<Crossing_index>(mesh_, contours);
    tunnels_.resize(contours.size());
    find_distant_tunnels(contours, find_near_tunnels(contours));
    for(Index k = 0; k < tunnels_.size(); ++k)
      if(tunnels_[k].empty()) {
        ++statistics.kept_sweep_tunnels;
        tunnels_[k] = descending_tunnel(mesh_, Arrival_order(passes_->arrival_times()),
                                        handle_candidates_[k]);
        tighten(tunnels_[k]);
      }
    passes_->report(statistics);
    progress_.end(Stage::TUNNEL);
  }

  /// paper, 4.3: for each tunnel the way from its left side around to its right side, which becomes
  /// the handle if it is shorter and the loops remain a basis. Where they would not, because the
  /// tunnels of several pairs led to one handle, the next best way is tried.
  void refinement_pass(Statistics& statistics) {
    progress_.start(Stage::REFINE);
    const Crossing_index index(mesh_, tunnels_);
    std::vector<std::vector<Crossing_loop>> candidates(tunnels_.size());
    Dual_loop_query search = {tunnels_, index, true, all_loops(), number_of_candidates};
    for(const Crossing_loop& handle : handles_)
      search.numbers_of_steps.push_back(steps_along(handle));
    passes_->search(search, progress_, [&](Index k, const Dual_walks& found) {
      for(const auto& walk : found.walks)
        candidates[k].push_back(pushed_left(mesh_, walk));
      progress_.advance_one(tunnels_.size());
    });
    Basis_exchange choice(tunnels_, *contour_index_, index);
    std::vector<Index> open = all_loops();
    for(std::size_t i = 0, ready = 0; i < number_of_candidates && !open.empty(); ++i) {
      if(i == ready)
        ready = tighten_candidates(open, i, candidates);
      open = replace_handles(open, i, candidates, choice);
    }
    statistics.kept_sweep_handles = open.size();
    passes_->report(statistics);
    progress_.end(Stage::REFINE);
  }

  /// the pairs, pulled taut; which loop of a pair is the handle remains to be seen.
  std::vector<Flat_pair> finished_pairs() {
    finish_pairs();
    std::vector<Flat_pair> pairs(handles_.size());
    for(std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k] = {std::move(handles_[k]), std::move(tunnels_[k])};
    return pairs;
  }

private:
  // Handles that are still contours of the sweep have been tightened only a little.
  void finish_pairs() {
    if(!options_.do_tighten)
      return;
    for_each_index(
        execution_, handles_.size(),
        [&](std::size_t k) {
          if(!is_refined_[k])
            tighten(handles_[k]);
          Gauss_reduction(mesh_).reduce(handles_[k], tunnels_[k]);
        },
        1);
    Dual_loop_improvement<Execution>(mesh_, progress_).improve(handles_, tunnels_);
  }

  std::vector<Index> all_loops() const {
    std::vector<Index> numbers(handle_candidates_.size());
    std::iota(numbers.begin(), numbers.end(), Index(0));
    return numbers;
  }

  // Two fronts for each loop. The loops share a number of updates, so that all of them together
  // cost no more than some sweeps over the mesh; those for which that is not enough share it once
  // more. Returns the loops that are left when most would need more than their share, as a sample
  // tells before much is spent.
  std::vector<Index> find_near_tunnels(const std::vector<Crossing_loop>& contours) {
    std::size_t sharing = contours.size();
    std::vector<Index> sample, others;
    for(Index k : all_loops())
      (sharing <= 16 || k % 16 == 0 ? sample : others).push_back(k); // all of a few, at a time
    std::vector<Index> open = search_tunnels(contours, sample, share_of_updates(sharing));
    if(!others.empty() && 2 * open.size() <= sample.size())
      others = search_tunnels(contours, others, share_of_updates(sharing));
    open.insert(open.end(), others.begin(), others.end());
    for(; !open.empty() && 2 * open.size() <= sharing;) {
      sharing = open.size();
      open = search_tunnels(contours, open, share_of_updates(sharing));
    }
    return open;
  }

  // A field that covers the mesh once takes about 23 updates per vertex.
  std::size_t share_of_updates(std::size_t number_of_loops) const {
    return 16 * 23 * mesh_.number_of_vertices() / (std::max)(number_of_loops, std::size_t(1)) + 1;
  }

  // Looks for the tunnels of the given loops. Returns those that need more updates.
  std::vector<Index> search_tunnels(const std::vector<Crossing_loop>& contours,
                                    const std::vector<Index>& numbers,
                                    std::size_t number_of_updates) {
    Dual_loop_query search = {contours, *contour_index_, false, numbers};
    search.number_of_updates = number_of_updates;
    std::vector<char> is_open(contours.size(), 0);
    passes_->search(search, progress_, [&](Index k, const Dual_walks& found) {
      is_open[k] = found.walks.empty() && found.has_given_up;
      if(!found.walks.empty())
        set_tunnel(k, found.walks.front());
    });
    return marked(numbers, is_open);
  }

  static std::vector<Index> marked(const std::vector<Index>& numbers,
                                   const std::vector<char>& is_marked) {
    std::vector<Index> result;
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(result),
                 [&](Index k) { return is_marked[k] != 0; });
    return result;
  }

  // One field for all loops together, where fronts of their own would cover the mesh again and
  // again.
  void find_distant_tunnels(const std::vector<Crossing_loop>& contours,
                            const std::vector<Index>& numbers) {
    if(numbers.empty())
      return;
    const Voronoi_regions regions(execution_, mesh_,
                                  passes_->times_from_loops(contours, *contour_index_), contours,
                                  *contour_index_);
    Workspace_pool<Voronoi_graph_search> searches([&] {
      return std::make_unique<Voronoi_graph_search>(mesh_, contours, *contour_index_, regions);
    });
    std::vector<char> is_open(contours.size(), 0);
    for_each_borrowed(searches, numbers, [&](Voronoi_graph_search& search, Index k) {
      const std::vector<Index> walk = search.dual_walk(k);
      is_open[k] = walk.empty();
      if(!walk.empty())
        set_tunnel(k, walk);
    });
    search_tunnels(contours, marked(numbers, is_open), (std::numeric_limits<std::size_t>::max)());
  }

  void set_tunnel(Index k, const std::vector<Index>& walk) {
    tunnels_[k] = pushed_left(mesh_, walk);
    tighten(tunnels_[k]);
    progress_.advance_one(tunnels_.size());
  }

  // How many refinements of a handle are tried.
  static constexpr Index number_of_candidates = 6;

  // Most contours are replaced in the refinement pass; until then it is enough to know about how
  // long they will be.
  static constexpr std::size_t few_rounds = 3;

  // With the number of rounds, if there is one.
  template <typename... Rounds> void tighten(Crossing_loop& loop, Rounds... rounds) const {
    if(options_.do_tighten)
      Loop_tightening(mesh_).tighten(loop, rounds...);
  }

  template <typename Workspace, typename Function>
  void for_each_borrowed(Workspace_pool<Workspace>& pool,
                         const std::vector<Index>& numbers,
                         const Function& f) {
    for_each_index(
        execution_, numbers.size(),
        [&](std::size_t i) {
          if(progress_.is_interrupted())
            return;
          auto workspace = pool.borrow();
          f(*workspace, numbers[i]);
        },
        1);
    progress_.throw_if_interrupted();
  }

  // A number of steps in which two fronts together go farther than the loop is long: each passes an
  // edge length in four steps, and a taut loop crosses two edges on it.
  static Time steps_along(const Crossing_loop& loop) {
    return static_cast<Time>(16 + loop.size() * 3 / 4);
  }

  // Tightens candidate i of the given handles: after the first ones, which mostly do, as many of
  // the next ones as well as there are threads that have nothing else to do. Returns the first that
  // it leaves.
  std::size_t tighten_candidates(const std::vector<Index>& numbers,
                                 std::size_t i,
                                 std::vector<std::vector<Crossing_loop>>& candidates) const {
    const std::size_t spare = i == 0 ? 1 : Execution::number_of_threads() / numbers.size();
    const std::size_t end =
        (std::min)(i + (std::max)(spare, std::size_t(1)), std::size_t(number_of_candidates));
    for_each_index(
        execution_, numbers.size() * (end - i),
        [&](std::size_t j) {
          std::vector<Crossing_loop>& ways = candidates[numbers[j % numbers.size()]];
          if(i + j / numbers.size() < ways.size())
            tighten(ways[i + j / numbers.size()]);
        },
        1);
    return end;
  }

  // Tries candidate i of the given handles, the largest gains first. Returns the handles that had
  // to be kept although the candidate is shorter.
  std::vector<Index> replace_handles(const std::vector<Index>& numbers,
                                     std::size_t i,
                                     std::vector<std::vector<Crossing_loop>>& candidates,
                                     Basis_exchange& choice) {
    std::vector<double> gain(candidates.size(), 0.);
    std::vector<std::optional<Basis_exchange::Row>> rows(candidates.size());
    for_each_index(
        execution_, numbers.size(),
        [&](std::size_t j) {
          const Index k = numbers[j];
          if(i >= candidates[k].size())
            return;
          gain[k] = length(mesh_, handles_[k]) - length(mesh_, candidates[k][i]);
          if(gain[k] > 0.)
            rows[k] = choice.handle_part(candidates[k][i]);
        },
        1);
    std::vector<Index> order = numbers;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return gain[a] > gain[b]; });
    std::vector<Index> kept;
    for(Index k : order) {
      if(gain[k] <= 0.)
        continue;
      is_refined_[k] = rows[k] && choice.accept(k, *rows[k]);
      if(is_refined_[k])
        handles_[k] = std::move(candidates[k][i]);
      else
        kept.push_back(k);
    }
    return kept;
  }

  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Options options_;
  std::optional<Passes> passes_; // prepared in the initial pass
  Progress& progress_;
  Execution execution_;
  std::vector<Handle_candidate> handle_candidates_;
  std::vector<Crossing_loop> handles_, tunnels_;
  std::vector<char> is_refined_; // by handle
  std::unique_ptr<Crossing_index> contour_index_;
};

/// The finder that a concurrency tag stands for. Specialised where a tag asks for another one,
/// which has the same `Options` and the same passes, to be called in their order, and takes part in
/// the tests of agreement.
template <typename ConcurrencyTag> struct Loop_pipeline_of
{
  using type = Loop_pipeline<decltype(execution<ConcurrencyTag>())>;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_LOOP_PIPELINE_H
