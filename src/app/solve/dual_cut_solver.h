// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DUAL_CUT_SOLVER_H
#define HTLOOPS_DUAL_CUT_SOLVER_H

#include "mesh_types.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/stages.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace htloops {

/// Halfedges and how often the cut runs along each, and the loop that crosses it once.
struct Dual_cut
{
  Loop loop;
  std::vector<std::pair<Mesh::Halfedge_index, std::int64_t>> edges;
};

struct Dual_cuts
{
  std::vector<Dual_cut> cuts;
  CGAL::Handle_tunnel_loops::Statistics statistics; ///< of the loops
};

/// the cuts dual to the loops that `loops` finds, and to the boundary curves.
Dual_cuts find_dual_cuts(const Mesh& mesh, int number_of_threads, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_DUAL_CUT_SOLVER_H
