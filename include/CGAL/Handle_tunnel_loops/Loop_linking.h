// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_LOOP_LINKING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_LOOP_LINKING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

The linking numbers of a loop with a family of loops. The linking number of two disjoint closed
curves is the number of times that one winds around the other.

The loops of pair k have the numbers 2k (the handle loop) and 2k + 1 (the tunnel loop). Let V(i, j)
be the linking number of loop i with loop j, where loop j is pushed off the surface, out of the
solid. If the loops are a basis of the first homology group and the surface does not cross itself,
then loop i bounds in the solid if and only if row i of V is zero, and it bounds outside the solid
if and only if column i is zero (Alexander duality). The solid is the set of points that an odd
number of components enclose; the orientation of the faces does not matter.
*/
struct Loop_linking
{
  /// The number of a loop, and a linking number that is not zero.
  using Number = std::pair<std::size_t, std::int64_t>;

  std::vector<Number> row;    ///< with all loops, itself included, pushed outwards
  std::vector<Number> column; ///< of all loops, itself included, with this loop pushed outwards

  /// whether the row (for the side of the solid) or the column (for the other side) is zero for all
  /// loops of the same component: the loop bounds on this side of its component if the component is
  /// considered without the others.
  bool bounds_inside_component = false, bounds_outside_component = false;

  /// why the numbers are meaningless, as text, because the surface touches or crosses itself; empty
  /// if they are valid. Of two loops of which neither has valid numbers, none is given.
  std::string problem;

  /// Returns whether the loop bounds a surface in the solid; `false` if this is undecided.
  bool bounds_inside() const { return problem.empty() && row.empty(); }

  /// Returns whether the loop bounds a surface in the space outside the solid; `false` if this is
  /// undecided.
  bool bounds_outside() const { return problem.empty() && column.empty(); }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOP_LINKING_H
