// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_MAKE_REFERENCE_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_MAKE_REFERENCE_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/// the passes as the paper has them, which need Eigen.
std::shared_ptr<Passes>
make_reference_passes(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options);

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_MAKE_REFERENCE_PASSES_H
