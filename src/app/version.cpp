// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "version.h"

#include <CGAL/version.h>

#if defined(CGAL_HTL_STD_THREADS)
#define HTLOOPS_THREADS "with threads"
#elif defined(CGAL_LINKED_WITH_TBB)
#define HTLOOPS_THREADS "with threads (TBB)"
#else
#define HTLOOPS_THREADS "without threads"
#endif

namespace htloops {

const char* version() {
  return "htloops " HTLOOPS_VERSION ", CGAL " CGAL_VERSION_STR ", " HTLOOPS_THREADS;
}

} // namespace htloops
