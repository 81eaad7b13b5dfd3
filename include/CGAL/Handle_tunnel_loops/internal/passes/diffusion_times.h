// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_TIMES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_TIMES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The arrival times of a diffusion that starts from the sources, if there are any; else from both
/// sides of the handle loops; and in components without any, from one vertex. All fields are those
/// of the passes.
CGAL_HTL_CORE std::vector<Time> diffusion_times(Passes& passes,
                                                const Pass_options& options,
                                                const Flat_mesh& mesh,
                                                const std::vector<Index>& sources,
                                                Progress& progress,
                                                Statistics& statistics);

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/passes/diffusion_times_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_TIMES_H
