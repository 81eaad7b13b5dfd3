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
#include "solve/thread_limit.h"

#include <CGAL/tags.h>

namespace htloops {

Answer solve_on_host(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  Answer answer = solve_with_library<CGAL::Parallel_if_available_tag>(mesh, options, progress);
  answer.backend = "host";
  answer.number_of_threads = limit.number_of_threads();
  return answer;
}

void diffuse_on_host(const Mesh& mesh,
                     const Reeb_options& options,
                     Progress& progress,
                     Reeb_answer& answer) {
  diffuse_with_library<CGAL::Parallel_if_available_tag>(mesh, options, progress, answer);
}

} // namespace htloops
