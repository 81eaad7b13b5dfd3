// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_MIDDLE_OF_CURVE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_MIDDLE_OF_CURVE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the vertex of a boundary curve that is in the middle of these, in the order of a function. A hub
/// with the same key is no critical point, unless the function has several maxima on the curve.
template <typename Key> Index middle_of_curve(const Flat_mesh& mesh, Index hub, const Key& key) {
  std::vector<Index> curve(mesh.ring(hub).begin(), mesh.ring(hub).end());
  const auto middle = curve.begin() + static_cast<std::ptrdiff_t>(curve.size() / 2);
  std::nth_element(curve.begin(), middle, curve.end(), [&](Index u, Index v) {
    return key(u) != key(v) ? key(u) < key(v) : mesh.original[u] < mesh.original[v];
  });
  return *middle;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_MIDDLE_OF_CURVE_H
