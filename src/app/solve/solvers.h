// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOLVERS_H
#define HTLOOPS_SOLVERS_H

#include "solve/backends.h"

// The functions behind the names of the backends; which of them there are depends on the build.
namespace htloops {

/// finds the loops with the processor's own threads.
Answer solve_on_host(const Mesh& mesh, const Solve_options& options, Progress& progress);

/// finds the loops with a CUDA device. Throws `Failure` if there is none that takes the mesh.
Answer solve_on_device(const Mesh& mesh, const Solve_options& options, Progress& progress);

/// finds the loops with a CUDA device if there is one that takes the mesh, else without.
Answer
solve_on_device_if_available(const Mesh& mesh, const Solve_options& options, Progress& progress);

/// finds the loops by the method of the paper, or to its letter, in one thread; logs the events of
/// the fronts.
Answer solve_by_reference(const Mesh& mesh, const Solve_options& options, Progress& progress);

void diffuse_on_host(const Mesh& mesh,
                     const Reeb_options& options,
                     Progress& progress,
                     Reeb_answer& answer);

void diffuse_on_device(const Mesh& mesh,
                       const Reeb_options& options,
                       Progress& progress,
                       Reeb_answer& answer);

void diffuse_on_device_if_available(const Mesh& mesh,
                                    const Reeb_options& options,
                                    Progress& progress,
                                    Reeb_answer& answer);

void diffuse_by_reference(const Mesh& mesh,
                          const Reeb_options& options,
                          Progress& progress,
                          Reeb_answer& answer);

} // namespace htloops

#endif // HTLOOPS_SOLVERS_H
