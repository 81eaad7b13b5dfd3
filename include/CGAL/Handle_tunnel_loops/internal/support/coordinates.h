// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_COORDINATES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_COORDINATES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/number_utils.h>

namespace CGAL::Handle_tunnel_loops::internal {

/// The coordinates of a vertex, rounded to doubles if they are none.
template <typename VertexPointMap, typename Vertex>
Vector coordinates(VertexPointMap point, const Vertex& v) {
  const auto& p = get(point, v);
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_COORDINATES_H
