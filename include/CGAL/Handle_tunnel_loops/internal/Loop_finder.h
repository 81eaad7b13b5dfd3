// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_FINDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_FINDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Loop_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/Refinement_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/Worker_pool.h>
#include <CGAL/Handle_tunnel_loops/internal/sweep_handles.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A pair of loops in the terms of the flat mesh.
struct Flat_pair
{
  Crossing_loop handle, tunnel;
};

/// The passes on the flat mesh, one after the other.
template <typename Execution>
class Loop_finder
{
public:
  struct Options
  {
    Field_constants constants;
    bool do_refine_handles = true;
    bool do_tighten = true;
  };

  /// \p seeds are the vertices to start from, one in each component.
  Loop_finder(const Flat_mesh& mesh, std::vector<Index> seeds, const Options& options,
              Progress& progress)
    : mesh_(mesh)
    , seeds_(std::move(seeds))
    , options_(options)
    , coefficients_(step_coefficients(options.constants))
    , progress_(progress)
    , speed_(mesh.number_of_vertices(), 1.f) {}

  /// paper, 4.1: the arrival times of one field over the whole mesh, and the handles read off them.
  void initial_pass()
  {
    progress_.start(Stage::INITIAL);
    Narrow_band band(mesh_, speed_, coefficients_);
    sweep(band);
    time_ = std::move(band.times());
    sweep_handles_ = find_sweep_handles(execution_, mesh_, Arrival_order(time_));
    handles_.resize(sweep_handles_.size());
    for_each_index(execution_, handles_.size(), [&](std::size_t k) {
      handles_[k] = sweep_handles_[k].loop;
      tighten(handles_[k]);
    }, 1);
    progress_.end(Stage::INITIAL);
  }

  /// paper, 4.2: for each handle the way from its left side around to its right side.
  void tunnel_pass(Statistics& statistics)
  {
    progress_.start(Stage::TUNNEL);
    std::vector<Crossing_loop> contours(sweep_handles_.size());
    for(std::size_t k = 0; k < contours.size(); ++k)
      contours[k] = std::move(sweep_handles_[k].loop);
    contour_index_ = std::make_unique<Crossing_index>(mesh_, contours);
    const Crossing_index& index = *contour_index_;
    const Index g = static_cast<Index>(contours.size());
    std::vector<char> is_from_sweep(g, 0);
    tunnels_.resize(g);
    for_each_loop([&](Loop_pass& pass, Index k) {
      const std::vector<Index> walk = pass.dual_walk(contours[k], k, g, index);
      is_from_sweep[k] = walk.empty();
      tunnels_[k] = walk.empty() ? sweep_tunnel(mesh_, Arrival_order(time_), sweep_handles_[k])
                                 : pushed_left(mesh_, walk);
      tighten(tunnels_[k]);
    });
    statistics.kept_sweep_tunnels =
        std::accumulate(is_from_sweep.begin(), is_from_sweep.end(), std::size_t(0));
    progress_.end(Stage::TUNNEL);
  }

  /// paper, 4.3: for each tunnel the way from its left side around to its right side, which becomes
  /// the handle if it is shorter and the loops remain a basis.
  void refinement_pass(Statistics& statistics)
  {
    progress_.start(Stage::REFINE);
    const Crossing_index index(mesh_, tunnels_);
    const Index g = static_cast<Index>(tunnels_.size());
    std::vector<Crossing_loop> refined(g);
    for_each_loop([&](Loop_pass& pass, Index k) {
      const std::vector<Index> walk = pass.dual_walk(tunnels_[k], k, k + 1, index);
      if(walk.empty())
        return;
      refined[k] = pushed_left(mesh_, walk);
      tighten(refined[k]);
    });
    statistics.kept_sweep_handles = replace_handles(refined, index);
    progress_.end(Stage::REFINE);
  }

  std::vector<Flat_pair> classified_pairs()
  {
    progress_.start(Stage::CLASSIFY);
    const Offset_classifier classifier(execution_, mesh_);
    std::vector<Flat_pair> pairs(handles_.size());
    for_each_index(execution_, pairs.size(), [&](std::size_t k) {
      pairs[k] = {std::move(handles_[k]), std::move(tunnels_[k])};
      if(classifier.growth(pairs[k].handle) < classifier.growth(pairs[k].tunnel))
        std::swap(pairs[k].handle, pairs[k].tunnel);
    }, 1);
    progress_.end(Stage::CLASSIFY);
    return pairs;
  }

private:
  void sweep(Narrow_band& band)
  {
    const No_walls walls;
    for(Index seed : seeds_) {
      band.add_source(seed, 0, walls);
      for(Index u : mesh_.ring(seed))
        band.add_source(u, 1, walls);
    }
    band.start(walls);
    const std::size_t n = mesh_.number_of_vertices();
    while(band.number_of_reached() < n && band.step(walls, [](Index) {}))
      if(band.number_of_steps() % 64 == 0)
        progress_.advance(double(band.number_of_reached()) / double(n));
  }

  void tighten(Crossing_loop& loop) const
  {
    if(options_.do_tighten)
      Loop_tightening(mesh_).tighten(loop);
  }

  template <typename Function> void for_each_loop(const Function& f)
  {
    Worker_pool<Loop_pass> passes([&] {
      return std::make_unique<Loop_pass>(mesh_, speed_, coefficients_);
    });
    for_each_index(execution_, sweep_handles_.size(), [&](std::size_t k) {
      if(progress_.is_interrupted())
        return;
      auto pass = passes.borrow();
      f(*pass, static_cast<Index>(k));
      progress_.advance_one(sweep_handles_.size());
    }, 1);
    progress_.throw_if_interrupted();
  }

  // Returns how many handles had to be kept although their refinements are shorter.
  std::size_t replace_handles(std::vector<Crossing_loop>& refined,
                              const Crossing_index& tunnel_index)
  {
    const Index g = static_cast<Index>(refined.size());
    std::vector<std::pair<double, Index>> gains;
    for(Index k = 0; k < g; ++k) {
      const double gain = length(mesh_, handles_[k]) - length(mesh_, refined[k]);
      if(!refined[k].empty() && gain > 0.)
        gains.emplace_back(-gain, k);
    }
    std::sort(gains.begin(), gains.end());
    Refinement_choice choice(tunnels_, *contour_index_, tunnel_index);
    std::size_t number_of_kept = 0;
    for(const auto& gain_and_handle : gains) {
      const Index k = gain_and_handle.second;
      if(choice.accept(k, refined[k]))
        handles_[k] = std::move(refined[k]);
      else
        ++number_of_kept;
    }
    return number_of_kept;
  }

  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Options options_;
  Step_coefficients coefficients_;
  Progress& progress_;
  Execution execution_;
  std::vector<float> speed_;
  std::vector<Time> time_;
  std::vector<Sweep_handle> sweep_handles_;
  std::vector<Crossing_loop> handles_, tunnels_;
  std::unique_ptr<Crossing_index> contour_index_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_FINDER_H
