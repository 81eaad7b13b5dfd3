// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_ROUNDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_ROUNDS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How far it is tried to remove handles.
enum class Removal_effort {
  GIVEN_LOOPS, ///< along the loops that they have
  ALL_LOOPS, ///< also along others nearby, and such that are found on the surface as it is by then
  MORE_LOOPS ///< of those nearby, also longer ones, and more of them, from the beginning
};

/*!
removes handles from a mesh, as far as that can be. What becomes of each is written to its task;
none is open at the end. With \p force, also where that is no repair. \p ask is told what part
is done, and throws to stop.

As long as some are removed and others are not, the loops of the surface are found anew, and those
that are left are tried as if it had been read just now. So nothing more is to be had of the result.
*/
void remove_handles(Execution execution,
                    Surgery_mesh& mesh,
                    std::vector<Removal_task>& tasks,
                    Removal_effort effort,
                    bool force,
                    const std::function<void(double)>& ask);

/// what the removal of each handle would be by itself: its task becomes what it would be if nothing
/// else was removed. The mesh stays as it is.
void try_to_remove_each(Execution execution,
                        Surgery_mesh& mesh,
                        std::vector<Removal_task>& tasks,
                        bool force,
                        const std::function<void(double)>& ask);

/// cuts a mesh apart at its necks, as far as that can be; what becomes of each is in its task.
std::vector<Removal_task>
remove_necks(Execution execution, Surgery_mesh& mesh, const Removal_options& wanted);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_ROUNDS_H
