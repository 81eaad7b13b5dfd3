// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REEB_SOLVER_H
#define HTLOOPS_REEB_SOLVER_H

#include "solve/progress.h"
#include "solve/reeb_answer.h"

#include <map>
#include <string>
#include <vector>

namespace htloops {

struct Reeb_options : CGAL::Handle_tunnel_loops::Reeb_options
{
  std::vector<Mesh::Vertex_index> sources; ///< of the diffusion; none: as the library chooses
  std::vector<double> values;              ///< by vertex, a function; none: a diffusion
  std::string backend = "auto";            ///< of the diffusion, see `choose_backend()`
  int number_of_threads = 0;               ///< 0: as many as the machine has
};

/// the measures by their names.
const std::map<std::string, CGAL::Reeb_measure>& reeb_measures();

/// computes a Reeb graph.
Reeb_answer find_reeb_graph(const Mesh& mesh, const Reeb_options& options, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_REEB_SOLVER_H
