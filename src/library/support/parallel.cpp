// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#if defined(CGAL_HTL_STD_THREADS)
#include <CGAL/Handle_tunnel_loops/internal/support/Thread_pool.h>
#elif defined(CGAL_LINKED_WITH_TBB)
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

std::size_t Execution::number_of_threads() const {
#if defined(CGAL_HTL_STD_THREADS)
  if(is_parallel_)
    return Thread_pool::instance().team().most;
#elif defined(CGAL_LINKED_WITH_TBB)
  if(is_parallel_)
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
#endif
  return 1;
}

void Execution::for_each_range(std::size_t number, const Range_function& f) const {
#if defined(CGAL_HTL_STD_THREADS)
  if(is_parallel_)
    return Thread_pool::instance().run(number, f.function, f.call);
#elif defined(CGAL_LINKED_WITH_TBB)
  if(is_parallel_)
    return tbb::parallel_for(std::size_t(0), number, [f](std::size_t i) { f.call(f.function, i); });
#endif
  for(std::size_t i = 0; i < number; ++i)
    f.call(f.function, i);
}

} // namespace CGAL::Handle_tunnel_loops::internal
