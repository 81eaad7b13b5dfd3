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

#include <CGAL/Handle_tunnel_loops/internal/pipeline/Passes.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The passes one after the other, from a mesh to pairs of loops.
class Loop_pipeline
{
public:
  Loop_pipeline(Passes& passes, const Pass_options& options, Progress& progress)
      : passes_(passes)
      , options_(options)
      , progress_(progress) {}

  std::vector<Flat_pair> run(Statistics& statistics) {
    run_initial_pass(statistics);
    run_stage(Stage::TUNNEL, [&] { passes_.tunnel_pass(progress_, statistics); });
    if(options_.do_refine_handles)
      run_stage(Stage::REFINE, [&] { passes_.refinement_pass(progress_, statistics); });
    if(options_.do_tighten)
      run_stage(Stage::SHORTEN, [&] { passes_.shorten(progress_); });
    return passes_.take_pairs();
  }

  /// the first of them alone, which is all there is to do where there are no handles.
  void run_initial_pass(Statistics& statistics) {
    run_stage(Stage::INITIAL, [&] { passes_.initial_pass(progress_, statistics); });
  }

private:
  template <typename Function> void run_stage(Stage stage, const Function& f) {
    progress_.start(stage);
    f();
    progress_.end(stage);
  }

  Passes& passes_;
  Pass_options options_;
  Progress& progress_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_LOOP_PIPELINE_H
