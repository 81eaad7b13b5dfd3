// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_FIELD_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_FIELD_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/pipeline/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Refinement_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Tunnel_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Dual_loop_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Gauss_reduction.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The passes on arrival times: handles are read off them exactly, and loops are tightened. The
/// fields are computed by a backend.
class Field_passes : public Passes
{
public:
  /// makes the backend, which may take a while, when it is needed first.
  using Make_backend = std::function<std::unique_ptr<Backend>()>;

  /// \p seeds are the vertices to start from, one in each component.
  Field_passes(Execution execution,
               const Flat_mesh& mesh,
               std::vector<Index> seeds,
               const Pass_options& options,
               Make_backend make_backend)
      : execution_(execution)
      , mesh_(mesh)
      , seeds_(std::move(seeds))
      , options_(options)
      , coefficients_(step_coefficients(options.field_constants))
      , make_backend_(std::move(make_backend)) {}

  void initial_pass(Progress& progress, Statistics& statistics) override {
    make_backend();
    candidates_ = backend_->initial_field(seeds_, coefficients_, [&](double part) {
      progress.advance(part);
      return true;
    });
    CGAL_postcondition_msg(candidates_.size() == mesh_.genus, "as many handles as the genus");
    statistics.swept_handles = candidates_.size();
    keep_what_is_asked_for(statistics);
    backend_->report(statistics);
    for(Handle_candidate& candidate : candidates_)
      contours_.push_back(std::move(candidate.loop));
    handles_ = contours_;
    is_refined_.assign(handles_.size(), 0);
    const Pass_context context = context_with(progress);
    context.for_each(handles_.size(),
                     [&](std::size_t k) { context.tighten(handles_[k], few_rounds); });
  }

  Swept_vertices take_swept_vertices() override { return std::move(swept_); }

  void tunnel_pass(Progress& progress, Statistics& statistics) override {
    const Pass_context context = context_with(progress);
    contour_index_ = std::make_unique<Crossing_index>(mesh_, contours_);
    tunnels_ = Tunnel_pass(context, contours_, *contour_index_).run();
    CGAL_assertion(tunnels_.size() == handles_.size());
    std::vector<Time> times;
    for(std::size_t k = 0; k < tunnels_.size(); ++k)
      if(tunnels_[k].empty()) {
        ++statistics.kept_sweep_tunnels;
        if(times.empty())
          times = backend_->arrival_times();
        tunnels_[k] = descending_tunnel(mesh_, Arrival_order(times), candidates_[k]);
        context.tighten(tunnels_[k]);
      }
    statistics.traced_tunnels = tunnels_.size() - statistics.kept_sweep_tunnels;
    CGAL_expensive_postcondition(are_tunnels_of_contours());
    contours_ = {};
    backend_->report(statistics);
  }

  void refinement_pass(Progress& progress, Statistics& statistics) override {
    const Pass_context context = context_with(progress);
    Refinement_pass pass(context, handles_, tunnels_, *contour_index_);
    statistics.kept_sweep_handles = pass.run();
    is_refined_ = pass.is_refined();
    statistics.refined_handles = static_cast<std::size_t>(
        std::count_if(is_refined_.begin(), is_refined_.end(), [](char c) { return c != 0; }));
    backend_->report(statistics);
  }

  void shorten(Progress& progress) override {
    const Pass_context context = context_with(progress);
    context.for_each(handles_.size(), [&](std::size_t k) {
      if(!is_refined_[k])
        context.tighten(handles_[k]);
      Gauss_reduction(context.execution, mesh_).reduce(handles_[k], tunnels_[k]);
      progress.advance_one(handles_.size());
    });
    Dual_loop_improvement(context.execution, mesh_, progress).improve(handles_, tunnels_);
  }

  std::vector<Flat_pair> take_pairs() override {
    CGAL_assertion(handles_.size() == tunnels_.size());
    std::vector<Flat_pair> pairs(handles_.size());
    for(std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k] = {std::move(handles_[k]), std::move(tunnels_[k])};
    return pairs;
  }

  std::vector<Time> diffusion(const std::vector<Index>& vertices,
                              Progress& progress,
                              Statistics& statistics) override {
    make_backend();
    std::vector<Time> times =
        backend_->times_from_vertices(vertices, coefficients_, [&](double part) {
          progress.advance(part);
          return true;
        });
    backend_->report(statistics);
    return times;
  }

private:
  // Most contours are replaced in the refinement pass; until then it is enough to know about how
  // long they will be.
  static constexpr std::size_t few_rounds = 3;

  void keep_what_is_asked_for(Statistics& statistics) {
    if(options_.do_log_fronts || options_.do_keep_layers) {
      Front_log log = backend_->front_log();
      if(options_.do_log_fronts)
        statistics.front_events = std::move(log.events);
      if(options_.do_keep_layers)
        swept_.layers = std::move(log.layer);
    }
    if(options_.do_keep_times)
      swept_.times = times_in_steps(backend_->arrival_times());
  }

  void make_backend() {
    if(backend_ == nullptr)
      backend_ = make_backend_();
  }

  // Whether each tunnel crosses its contour once and none that was found later.
  bool are_tunnels_of_contours() const {
    for(Index k = 0; k < tunnels_.size(); ++k)
      if(!is_dual(contour_index_->intersections(tunnels_[k]), k, Loops_from{k}))
        return false;
    return true;
  }

  Pass_context context_with(Progress& progress) const {
    return {execution_.watched_by(progress),
            mesh_,
            *backend_,
            coefficients_for_searching(coefficients_),
            options_.do_tighten,
            progress};
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Pass_options options_;
  Step_coefficients coefficients_;
  Make_backend make_backend_;
  std::unique_ptr<Backend> backend_;
  Swept_vertices swept_;
  std::vector<Handle_candidate> candidates_; // their loops are the contours
  std::vector<Crossing_loop> contours_, handles_, tunnels_;
  std::vector<char> is_refined_; // by handle
  std::unique_ptr<Crossing_index> contour_index_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_FIELD_PASSES_H
