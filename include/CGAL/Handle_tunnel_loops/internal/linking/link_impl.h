// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Linking_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/link.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE Linking link(Execution execution, const Surface_curves& curves, bool do_link) {
  Linking_numbers numbers(execution, curves);
  if(do_link)
    numbers.link(execution);
  return {numbers.intersections(), numbers.linking(), numbers.defect(), numbers.contacts(),
          numbers.has_too_many_contacts()};
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_IMPL_H
