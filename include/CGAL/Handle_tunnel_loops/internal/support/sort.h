// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// sorts; not stable.
template <typename Iterator, typename Less>
void sort(Execution execution, Iterator first, Iterator last, const Less& less) {
#ifdef CGAL_LINKED_WITH_TBB
  if(execution.is_parallel())
    return tbb::parallel_sort(first, last, less);
#endif
  (void)execution;
  std::sort(first, last, less);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORT_H
