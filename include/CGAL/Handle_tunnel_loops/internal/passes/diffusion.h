// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The arrival times of a diffusion that starts from the sources, if there are any, as
/// `diffusion_times()` says; by passes on the mesh.
std::vector<std::uint32_t> times_of_diffusion(const Flat_mesh& mesh,
                                              Make_passes make_passes,
                                              const Solver_options& given,
                                              const std::vector<Index>& sources,
                                              const std::function<bool(double)>& callback,
                                              Statistics& statistics);

/// of these times to one step of the field.
double ticks_per_step_of_diffusion();

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_H
