// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SOLID_SIDES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SOLID_SIDES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

using Triangle = std::array<Vector, 3>;

/// the signs of the volumes that components enclose, exactly. `for_each_triangle(f)` calls
/// `f(component, triangle)` for all of their triangles.
CGAL_HTL_CORE std::vector<int> signs_of_volumes(
    std::size_t number_of_components,
    const std::function<void(const std::function<void(std::size_t, const Triangle&)>&)>&
        for_each_triangle);

/// Where a triangle is seen from a point if one looks up or down from it.
enum class Seen_triangle { NOWHERE, ABOVE, HERE, BELOW };

/// says it exactly. The point is moved aside by an infinitesimal amount, so that it lies above no
/// edge.
CGAL_HTL_CORE Seen_triangle see_triangle(const Triangle& t, const Vector& point);

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/linking/solid_sides_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SOLID_SIDES_H
