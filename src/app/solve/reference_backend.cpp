// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/library_backend.h"
#include "solve/library_reeb.h"
#include "solve/solvers.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>

namespace htloops {

Answer solve_by_reference(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  Answer answer = solve_with_library<CGAL::Reference_tag>(mesh, options, progress);
  answer.backend = "reference";
  return answer;
}

void diffuse_by_reference(const Mesh& mesh,
                          const Reeb_options& options,
                          Progress& progress,
                          Reeb_answer& answer) {
  diffuse_with_library<CGAL::Reference_tag>(mesh, options, progress, answer);
  answer.number_of_threads = 1;
}

} // namespace htloops
