// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_DIAMETERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_DIAMETERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// for each task: the diameter of the narrowest cylinder in the wall of the bore that its first
/// loop goes around, if there is one.
CGAL_HTL_CORE std::vector<std::optional<double>> bore_diameters(
    Execution execution, const Surgery_mesh& mesh, const std::vector<Removal_task>& tasks);

} // namespace CGAL::Handle_tunnel_loops::internal

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/surgery/bore_diameters_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_DIAMETERS_H
