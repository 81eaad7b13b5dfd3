// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the passes one after the other, from a mesh with handles to pairs of loops.
std::vector<Flat_pair>
run_passes(Passes& passes, const Pass_options& options, Progress& progress, Statistics& statistics);

/// the first of them alone, which is all there is to do where there are no handles.
void run_initial_pass(Passes& passes, Progress& progress, Statistics& statistics);

/// The arrival times of a diffusion that starts from the sources, if there are any; else from both
/// sides of the handle loops; and in components without any, from one vertex. All fields are those
/// of the passes.
std::vector<Time> diffusion_times(Passes& passes,
                                  const Pass_options& options,
                                  const Flat_mesh& mesh,
                                  const std::vector<Index>& sources,
                                  Progress& progress,
                                  Statistics& statistics);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_H
