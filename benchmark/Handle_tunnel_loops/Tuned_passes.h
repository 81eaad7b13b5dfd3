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

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Field_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>

#include <CGAL/tags.h>

#include <memory>

namespace benchmark_device {

namespace impl = CGAL::Handle_tunnel_loops::internal;

/// What the stages of a run took, from arrays to loops, and what they cost on the device.
struct Tuned_run
{
  CGAL::Handle_tunnel_loops::Statistics statistics;
  impl::device::Costs costs;
};

/// The passes on a device that is used as `tuning` says.
inline Tuned_run run_tuned(const impl::Flat_mesh& mesh, const impl::device::Tuning& tuning) {
  using CGAL::Handle_tunnel_loops::Stage;
  Tuned_run run;
  const auto nothing = [](Stage) {};
  impl::Progress progress({}, nothing, nothing, run.statistics, impl::Progress::stages_of_loops());
  const impl::device::Solver* solver = nullptr;
  impl::Field_passes<impl::device::Solver> passes(
      impl::execution_of<CGAL::Parallel_if_available_tag>(), mesh, mesh.seeds, impl::Pass_options(),
      [&] {
        auto made = impl::device::make_cuda_solver(mesh, {}, tuning);
        solver = made.get();
        return made;
      });
  impl::run_passes(passes, impl::Pass_options(), progress, run.statistics);
  run.costs = solver->costs();
  return run;
}

} // namespace benchmark_device

#endif // HTL_BENCHMARK_TUNED_PASSES_H
