// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSIFICATION_LOOP_GROWTH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSIFICATION_LOOP_GROWTH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/core.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A loop with the faces along it, as far as its growth needs them.
struct Loop_with_faces
{
  /// A point of the loop on the edge from p to q, or at one of these.
  struct Step
  {
    Vector p, q;
    double ratio;
    bool is_vertex;
    std::size_t end_of_faces; ///< one past the last face that contains the point
  };

  std::vector<Step> steps;
  std::vector<std::array<Vector, 3>> faces; ///< by step
};

/// see `Offset_classifier`.
CGAL_HTL_CORE double growth_of(const Loop_with_faces& loop);
CGAL_HTL_CORE int compare_growth_of(const Loop_with_faces& a, const Loop_with_faces& b);

/// the length of a loop whose points are moved by the given way along their normals, rounded; it
/// stays where there are none.
CGAL_HTL_CORE double length_at_offset(const Loop_with_faces& loop, double offset);

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/classification/Loop_growth_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSIFICATION_LOOP_GROWTH_H
