// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_PATH_BACK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_PATH_BACK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/steepest_descent.h>
#include <CGAL/Handle_tunnel_loops/internal/kernels/Field.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// the next cell on the way back from a cell that is reached to the source that its front set out
/// from: down the steepest edge, on the same side and through no wall. It was reached earlier, so
/// ways end. `no_index` if there is none, which would be an error.
template <typename Domain>
CGAL_HTL_HOST_DEVICE Index path_back(const Field<Domain>& field, const Located_cell& c) {
  const std::uint32_t side = field.side(c.cell);
  const Index next = steepest_descent(
      field.domain().mesh(), c.vertex,
      [&](Index u) {
        const Index neighbor = field.domain().find(c, u);
        return neighbor == no_index ? never : field.time(neighbor);
      },
      [&](Index u) {
        return field.side(field.domain().find(c, u)) == side && !field.domain().is_wall(c, u);
      });
  return next == c.vertex ? no_index : field.domain().find(c, next);
}

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_PATH_BACK_H
