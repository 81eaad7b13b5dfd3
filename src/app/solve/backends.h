// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_BACKENDS_H
#define HTLOOPS_BACKENDS_H

#include "mesh_types.h"
#include "solve/answer.h"
#include "solve/progress.h"
#include "solve/reeb_solver.h"

#include <CGAL/Handle_tunnel_loops/Solver_options.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

struct Solve_options : CGAL::Handle_tunnel_loops::Solver_options
{
  std::optional<Mesh::Vertex_index> seed;
  bool do_find_layers = false; ///< and arrival times
  Basis_kind basis_kind = Basis_kind::PURE;
  double maximum_running_time = (std::numeric_limits<double>::infinity)(); ///< seconds
  int number_of_threads = 0; ///< 0: as many as the machine has
};

/// One of the programs that find the loops.
struct Backend
{
  const char* name;
  bool is_chosen_by_auto;
  /// null in a build without it. Throws `CGAL::Handle_tunnel_loops::Device_exception` if there is
  /// no device that takes the mesh, where one was asked for.
  Answer (*solve)(const Mesh&, const Solve_options&, Progress&);
  /// the Reeb graph of a diffusion; null as well.
  void (*diffuse)(const Mesh&, const Reeb_options&, Progress&, Reeb_answer&);
};

/// The processor's own threads; a CUDA device; that if there is one that takes the mesh, else the
/// threads; the method of the paper, or its letter, in one thread, which logs the events of fronts.
extern const Backend host_backend, cuda_backend, automatic_backend, reference_backend;

/// the backend of that name; for "auto" the first that there is of those that may be chosen so.
/// Throws `Failure` if this build has none.
const Backend& choose_backend(const std::string& name);

/// what `choose_backend()` accepts.
std::vector<std::string> names_of_backends();

} // namespace htloops

#endif // HTLOOPS_BACKENDS_H
