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

#include <vector>

namespace htloops {

struct Cut_options
{
  std::vector<Mesh::Vertex_index> cones; ///< vertices that the cut has to pass
  bool do_cut_spheres = false;
  int number_of_threads = 0; ///< 0: as many as the machine has
};

struct Cut_answer
{
  std::vector<Mesh::Edge_index> edges;
  std::size_t genus = 0; ///< of the mesh, summed over its components
  double length = 0.;
  double boundary_length = 0.; ///< of the opened mesh
  double total_seconds = 0.;
  int number_of_threads = 0;
};

Cut_answer find_cut(const Mesh& mesh, const Cut_options& options, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_CUT_SOLVER_H
