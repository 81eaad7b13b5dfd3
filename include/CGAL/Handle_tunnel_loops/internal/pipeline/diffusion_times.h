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

#include <CGAL/Handle_tunnel_loops/internal/classification/Offset_growth.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Diffusion_field.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Loop_pipeline.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Passes_of_tag.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
  progress.start(Stage::DIFFUSION);
  Diffusion_field field(execution_of<ConcurrencyTag>(), mesh, constants);
  for(Index v : sources)
    field.add_source(v);
  const Offset_growth growth(mesh);
  for(const Flat_pair& pair : pairs)
    field.add_source(growth(pair.handle) >= growth(pair.tunnel) ? pair.handle : pair.tunnel);
  field.complete_sources(progress);
  std::vector<Time> times = field.times(progress);
  progress.end(Stage::DIFFUSION);
  return times;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_H
