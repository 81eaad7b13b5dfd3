// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_MAKE_HOST_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_MAKE_HOST_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the passes on the processor. \p seeds are the vertices to start from, one in each component;
/// \p fallback says why it is not a device, if one was asked for.
CGAL_HTL_CORE std::unique_ptr<Passes> make_host_passes(Execution execution,
                                                       const Flat_mesh& mesh,
                                                       std::vector<Index> seeds,
                                                       const Pass_options& options,
                                                       std::string fallback = {});

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/pipeline/make_host_passes_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_MAKE_HOST_PASSES_H
