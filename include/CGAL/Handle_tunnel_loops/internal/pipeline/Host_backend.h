// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_HOST_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_HOST_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Device_options.h>
#include <CGAL/Handle_tunnel_loops/internal/executors/Processor_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/fronts/Front_layers.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Bidirectional_front.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Dual_loop_query.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Workspace_pool.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The fields of the passes, on the processor. `Device_backend` provides the same.
template <typename Execution> class Host_backend
{
public:
  Host_backend(const Flat_mesh& mesh, const Step_coefficients& k, const Device_options& = {})
      : mesh_(mesh)
      , coefficients_(k)
      , coefficients_for_searching_(internal::coefficients_for_searching(k))
      , stencils_(execution_, mesh) {}

  void report(Statistics& statistics) const { statistics.backend = "host"; }

  /// the handles of the sweep from one vertex in each component.
  std::vector<Handle_candidate> sweep(const std::vector<Index>& seeds, Progress& progress) {
    Narrow_band band(mesh_, stencils_, coefficients_);
    for(Index seed : seeds) {
      band.add_source(seed, 0);
      for(Index u : mesh_.ring(seed))
        band.add_source(u, 1);
    }
    const No_walls walls;
    band.start(walls);
    const std::size_t n = mesh_.number_of_vertices();
    while(band.number_of_reached() < n && band.step(walls, [](Index) {}))
      if(band.number_of_steps() % 64 == 0)
        progress.advance(double(band.number_of_reached()) / double(n));
    times_ = band.take_times();
    return find_handle_candidates(execution_, mesh_, Arrival_order(times_));
  }

  /// the arrival times of the last sweep.
  const std::vector<Time>& arrival_times() const { return times_; }

  /// takes those of a sweep elsewhere for its own.
  void set_sweep_times(std::vector<Time> times) { times_ = std::move(times); }

  /// the layers of the last sweep, and what happened to its fronts.
  Front_log front_log() const {
    using Executor = device::Processor_executor<Execution>;
    Executor executor;
    const device::Span<const Time> times(times_.data(), times_.size());
    return device::Front_layers<Executor>(executor, mesh_, device::view_of(mesh_), times).run();
  }

  /// the arrival times of one field from both sides of all loops, none of which it crosses.
  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index) const {
    Narrow_band band(mesh_, stencils_, coefficients_for_searching_);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(index.has_crossing(v))
        band.expect_walls(v);
    for(const Crossing_loop& loop : loops)
      for(const Crossing& c : loop)
        for(Index v : {c.left, c.right})
          band.add_source(v, 0);
    const Loops_from all_loops = {0};
    const Loop_walls<Loops_from> walls(index, all_loops);
    band.start(walls);
    while(band.step(walls, [](Index) {}))
      ;
    return band.take_times();
  }

  /// calls `f(k, found)` for the loops that are searched for; several threads may.
  template <typename Function>
  void search(const Dual_loop_query& search, Progress& progress, const Function& f) const {
    if(search.bars_only_own)
      search_with<Only_loop>(search, progress, f);
    else
      search_with<Loops_from>(search, progress, f);
  }

private:
  template <typename Loop_set, typename Function>
  void search_with(const Dual_loop_query& search, Progress& progress, const Function& f) const {
    using Pass = Bidirectional_front<Loop_set>;
    Workspace_pool<Pass> passes([&] {
      return std::make_unique<Pass>(mesh_, stencils_, coefficients_for_searching_, search.index);
    });
    for_each_index(
        execution_, search.numbers.size(),
        [&](std::size_t i) {
          if(progress.is_interrupted())
            return;
          const Index k = search.numbers[i];
          typename Pass::Limits limits;
          limits.number_of_walks = search.number_of_walks;
          limits.number_of_updates = search.number_of_updates;
          if(!search.numbers_of_steps.empty())
            limits.number_of_steps = search.numbers_of_steps[k];
          auto pass = passes.borrow();
          Dual_walks found;
          found.walks = pass->dual_walks(search.loops[k], k, {k}, limits);
          found.has_given_up = pass->has_given_up();
          f(k, found);
        },
        1);
    progress.throw_if_interrupted();
  }

  const Flat_mesh& mesh_;
  Step_coefficients coefficients_, coefficients_for_searching_;
  Execution execution_;
  Stencils stencils_;
  std::vector<Time> times_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_HOST_BACKEND_H
