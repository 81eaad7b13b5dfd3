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

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// throws `No_cut_exception` if the rules for edges leave no cut.
void check_rules(const Cut_problem& problem);

/// the edges, a halfedge of each, along which every component falls open to one disk, with those to
/// hubs, if there are any; none on components of genus 0 unless they have cones or kept edges, or
/// spheres are to be cut.
std::vector<Index> cut_open(Cut_problem problem);

/// halfedges, and how often each is passed.
using Chain_of_halfedges = std::vector<std::pair<Index, std::int64_t>>;

/// the chains along a cut that are dual to the walks of the problem, and after these to the
/// boundary curves that `hubs_of_basis()` names; without edges to hubs.
std::vector<Chain_of_halfedges> dual_chains(const Cut_problem& problem);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_OPEN_H
