// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_BENCHMARK_TUNED_PASSES_H
#define HTL_BENCHMARK_TUNED_PASSES_H

#include <CGAL/Handle_tunnel_loops/internal/pipeline/Device_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Loop_pipeline.h>

#include <functional>
#include <vector>

namespace benchmark_device {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using Execution = decltype(impl::execution<CGAL::Parallel_if_available_tag>());

/// The passes on a device that is used as `tuning` says, for a `Loop_pipeline`; what they cost is
/// added to `costs` in the end.
struct Tuned_passes : impl::Device_backend<Execution>
{
  static inline impl::device::Tuning tuning;
  static inline impl::device::Costs costs_of_last;

  Tuned_passes(const impl::Flat_mesh& mesh,
               const impl::Step_coefficients& k,
               const CGAL::Handle_tunnel_loops::Device_options& options)
      : impl::Device_backend<Execution>(mesh, k, options, tuning) {}
  ~Tuned_passes() { costs_of_last = costs(); }
};

/// What the stages of a run took, from arrays to loops, and what they cost on the device.
struct Tuned_run
{
  CGAL::Handle_tunnel_loops::Statistics statistics;
  impl::device::Costs costs;
};

inline Tuned_run run_tuned(const impl::Flat_mesh& mesh, const impl::device::Tuning& tuning) {
  using Finder = impl::Loop_pipeline<Execution, Tuned_passes>;
  using CGAL::Handle_tunnel_loops::Stage;
  Tuned_passes::tuning = tuning;
  Tuned_run run;
  const auto nothing = [](Stage) {};
  impl::Progress progress({}, nothing, nothing, run.statistics);
  {
    Finder finder(mesh, mesh.seeds, typename Finder::Options(), progress);
    finder.initial_pass(run.statistics);
    finder.tunnel_pass(run.statistics);
    finder.refinement_pass(run.statistics);
    progress.start(Stage::CLASSIFY);
    finder.finished_pairs();
    progress.end(Stage::CLASSIFY);
  }
  run.costs = Tuned_passes::costs_of_last;
  return run;
}

} // namespace benchmark_device

#endif // HTL_BENCHMARK_TUNED_PASSES_H
