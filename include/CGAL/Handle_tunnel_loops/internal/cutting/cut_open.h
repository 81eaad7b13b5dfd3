// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// throws `No_cut_exception` if the rules for edges leave no cut.
CGAL_HTL_CORE void check_rules(const Cut_problem& problem);

/// the edges, a halfedge of each, along which every component falls open to one disk, with those to
/// hubs, if there are any; none on components of genus 0 unless they have cones or kept edges, or
/// spheres are to be cut.
CGAL_HTL_CORE std::vector<Index> cut_open(Cut_problem problem);

} // namespace CGAL::Handle_tunnel_loops::internal

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/cutting/cut_open_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_H
