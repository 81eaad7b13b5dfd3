// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Loop_pipeline.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Passes_of_tag.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The arrival times of a diffusion that starts from the sources and from the handle loops of the
/// pairs; in components without any, from one vertex.
CGAL_HTL_CORE std::vector<Time> diffusion_times(Execution execution,
                                                const Flat_mesh& mesh,
                                                const std::vector<Index>& sources,
                                                const std::vector<Flat_pair>& pairs,
                                                const Field_constants& constants,
                                                Progress& progress);

/// The arrival times of a diffusion that starts from the sources, if there are any; in components
/// without one, from both sides of the handle loops, or else from one vertex.
template <typename ConcurrencyTag>
std::vector<Time> diffusion_times(const Flat_mesh& mesh,
                                  const std::vector<Index>& sources,
                                  const Field_constants& constants,
                                  Progress& progress) {
  std::vector<Flat_pair> pairs;
  if(sources.empty() && mesh.genus > 0) {
    Pass_options options;
    options.constants = constants;
    options.do_tighten = false; // a front forgets where exactly it started
    const auto passes =
        Passes_of_tag<ConcurrencyTag>::make(mesh, mesh.seeds, options, Device_options());
    Statistics statistics;
    pairs = Loop_pipeline(*passes, options, progress).run(statistics);
  }
  return diffusion_times(execution_of<ConcurrencyTag>(), mesh, sources, pairs, constants, progress);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/pipeline/diffusion_times_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_H
