// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "failure.h"
#include "solve/library_backend.h"
#include "solve/library_reeb.h"
#include "solve/solvers.h"
#include "solve/thread_limit.h"

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>

namespace htloops {
namespace {

template <typename ConcurrencyTag>
Answer solve(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  Answer answer = solve_with_library<ConcurrencyTag>(mesh, options, progress);
  // Where there is no handle, there is no field to compute.
  answer.backend = answer.statistics.backend.empty() ? "host" : answer.statistics.backend;
  answer.number_of_threads = limit.number_of_threads();
  return answer;
}

// What was asked for is not there.
template <typename Function> auto on_device(const Function& f) {
  using namespace CGAL::Handle_tunnel_loops;
  try {
    return f();
  } catch(const No_device_exception& exception) {
    throw Failure(Exit_code::NO_BACKEND, exception.what());
  } catch(const Out_of_device_memory_exception& exception) {
    throw Failure(Exit_code::NO_BACKEND, exception.what());
  }
}

} // namespace

Answer solve_on_device(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  return on_device([&] { return solve<CGAL::Cuda_tag>(mesh, options, progress); });
}

Answer
solve_on_device_if_available(const Mesh& mesh, const Solve_options& options, Progress& progress) {
  return solve<CGAL::Cuda_if_available_tag>(mesh, options, progress);
}

void diffuse_on_device(const Mesh& mesh,
                       const Reeb_options& options,
                       Progress& progress,
                       Reeb_answer& answer) {
  on_device([&] { diffuse_with_library<CGAL::Cuda_tag>(mesh, options, progress, answer); });
}

void diffuse_on_device_if_available(const Mesh& mesh,
                                    const Reeb_options& options,
                                    Progress& progress,
                                    Reeb_answer& answer) {
  diffuse_with_library<CGAL::Cuda_if_available_tag>(mesh, options, progress, answer);
}

} // namespace htloops
