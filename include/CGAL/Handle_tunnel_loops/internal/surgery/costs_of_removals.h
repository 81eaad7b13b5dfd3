// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_COSTS_OF_REMOVALS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_COSTS_OF_REMOVALS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_costs.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/removal.h>

#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// what removing each handle by itself would cost.
std::vector<Removal_costs> costs_of_removals(Execution execution,
                                             const Triangle_list& triangles,
                                             const std::vector<Choice_of_handle>& handles,
                                             bool force,
                                             const std::function<bool(double)>& callback);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_COSTS_OF_REMOVALS_H
