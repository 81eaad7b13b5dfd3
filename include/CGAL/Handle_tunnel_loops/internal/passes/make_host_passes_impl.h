// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_MAKE_HOST_PASSES_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_MAKE_HOST_PASSES_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/passes/Field_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes_of_tag.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE std::unique_ptr<Passes> make_host_passes(Execution execution,
                                                       const Flat_mesh& mesh,
                                                       std::vector<Index> seeds,
                                                       const Pass_options& options,
                                                       std::string fallback) {
  return std::make_unique<Field_passes>(execution, mesh, std::move(seeds), options,
                                        [execution, &mesh, fallback = std::move(fallback)] {
                                          return std::make_unique<Host_backend>(execution, mesh,
                                                                                fallback);
                                        });
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_MAKE_HOST_PASSES_IMPL_H
