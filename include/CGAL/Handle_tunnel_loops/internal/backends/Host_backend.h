// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_BACKENDS_HOST_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_BACKENDS_HOST_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/backends/Backend.h>
#include <CGAL/Handle_tunnel_loops/internal/executors/Processor_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Narrow_band.h>
#include <CGAL/Handle_tunnel_loops/internal/fronts/Front_layers.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Bidirectional_front.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Workspace_pool.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// On the processor, in a narrow band; the loop passes side by side.
class Host_backend : public Backend
{
public:
  /// \p fallback says why it is not a device, if one was asked for.
  Host_backend(Execution execution, const Flat_mesh& mesh, std::string fallback = {})
      : execution_(execution)
      , mesh_(mesh)
      , fallback_(std::move(fallback))
      , stencils_(execution, mesh) {}

  std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                              const Step_coefficients& k,
                                              const Callback& callback) override {
    times_ = times_from_vertices(seeds, k, callback);
    CGAL_assertion_msg(std::find(times_.begin(), times_.end(), never) == times_.end(),
                       "there is a seed in each component");
    return find_handle_candidates(execution_, mesh_, times_);
  }

  std::vector<Time> arrival_times() override { return times_; }

  bool has_arrival_times() const { return !times_.empty(); }

  /// takes those of an initial field elsewhere for its own.
  void set_arrival_times(std::vector<Time> times) { times_ = std::move(times); }

  Front_log front_log() override {
    Processor_executor executor(execution_);
    const Span<const Time> times(times_.data(), times_.size());
    return Front_layers<Processor_executor>(executor, mesh_, view_of(mesh_), times).run();
  }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k) override {
    Narrow_band band(mesh_, stencils_, k);
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

  std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                        const Step_coefficients& k,
                                        const Callback& callback) override {
    Narrow_band band(mesh_, stencils_, k);
    add_sources_with_rings(band, mesh_, vertices);
    grow(band, mesh_.number_of_vertices(), [&](double part) {
      if(!callback(part))
        throw Interrupted_exception();
    });
    return band.take_times();
  }

  std::vector<Dual_walks> dual_walks(const Dual_loop_query& query,
                                     const Step_coefficients& k,
                                     const Callback& callback) override {
    return query.bars_only_own ? dual_walks_with<Only_loop>(query, k, callback)
                               : dual_walks_with<Loops_from>(query, k, callback);
  }

  void report(Statistics& statistics) const override {
    statistics.backend = "host";
    statistics.fallback = fallback_;
  }

private:
  template <typename Loop_set>
  std::vector<Dual_walks> dual_walks_with(const Dual_loop_query& query,
                                          const Step_coefficients& k,
                                          const Callback& callback) const {
    using Fronts = Bidirectional_front<Loop_set>;
    Workspace_pool<Fronts> pool(
        [&] { return std::make_unique<Fronts>(mesh_, stencils_, k, query.index); });
    std::vector<Dual_walks> found(query.numbers.size());
    std::atomic<std::size_t> number_of_done{0};
    std::atomic<bool> is_stopped{false};
    for_each_index(
        execution_, found.size(),
        [&](std::size_t i) {
          if(is_stopped)
            return;
          auto fronts = pool.borrow();
          found[i] = fronts->dual_walks(query, query.numbers[i]);
          if(!callback(double(++number_of_done) / double(found.size())))
            is_stopped = true;
        },
        1);
    if(is_stopped)
      throw Interrupted_exception();
    return found;
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::string fallback_;
  Stencils stencils_;
  std::vector<Time> times_; // of the last initial field
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_BACKENDS_HOST_BACKEND_H
