// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/necks/find_flat_necks.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE std::vector<Flat_neck>
find_flat_necks(Execution, const Flat_mesh&, const Neck_limits&) {
  return {};
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_IMPL_H
