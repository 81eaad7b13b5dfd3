// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classification/Offset_growth.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Diffusion_field.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/diffusion_times.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE std::vector<Time> diffusion_times(Execution execution,
                                                const Flat_mesh& mesh,
                                                const std::vector<Index>& sources,
                                                const std::vector<Flat_pair>& pairs,
                                                const Field_constants& constants,
                                                Progress& progress) {
  progress.start(Stage::DIFFUSION);
  Diffusion_field field(execution, mesh, constants);
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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DIFFUSION_TIMES_IMPL_H
