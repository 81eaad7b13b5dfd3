// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CUT_SOLVER_H
#define HTLOOPS_CUT_SOLVER_H

#include "mesh_types.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/stages.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace htloops {

struct Cut_options
{
  std::vector<Mesh::Vertex_index> cones; ///< vertices that the cut has to pass
  Face_cuts avoided;                     ///< edges that it must not pass; empty: none
  bool do_cut_spheres = false;
  int number_of_threads = 0; ///< 0: as many as the machine has
};

struct Cut_answer
{
  std::vector<Mesh::Edge_index> edges;
  std::size_t genus = 0; ///< of the mesh, summed over its components
  double length = 0.;
  double boundary_length = 0.; ///< of the opened mesh
};

Cut_answer find_cut(const Mesh& mesh, const Cut_options& options, Progress& progress);

/// Halfedges and how often the cut runs along each, and the loop that crosses it once.
struct Dual_cut
{
  Loop loop;
  std::vector<std::pair<Mesh::Halfedge_index, std::int64_t>> edges;
};

struct Dual_cuts
{
  std::vector<Dual_cut> cuts;
  std::vector<Loop> boundaries;                     ///< all boundary curves
  CGAL::Handle_tunnel_loops::Statistics statistics; ///< of the loops
};

/// the length of all cuts, which counts an edge as often as they run along it.
double length_of(const Mesh& mesh, const Dual_cuts& duals);

/// the cuts dual to the loops that `loops` finds, and to the boundary curves.
Dual_cuts find_dual_cuts(const Mesh& mesh, int number_of_threads, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_CUT_SOLVER_H
