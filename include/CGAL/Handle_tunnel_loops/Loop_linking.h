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

How a loop of a family lies in space, by linking numbers: that of two disjoint closed curves is the
number of times that one winds around the other.

The loops of pair k have the numbers 2k, the handle loop, and 2k + 1, the tunnel loop. Let V(i, j)
be the linking number of loop i with loop j when loop j is pushed off the surface, out of the solid.
If the loops are a basis of the first homology group and the surface does not cross itself, a loop
bounds in the solid exactly if its row of V is zero, and outside exactly if its column is (Alexander
duality). The solid are the points that are enclosed by an odd number of components; how the faces
are oriented plays no part.
*/
struct Loop_linking
{
  /// the number of a loop, and a linking number that is not zero.
  using Number = std::pair<std::size_t, std::int64_t>;

  std::vector<Number> row;    ///< with the other loops, and itself, pushed outwards
  std::vector<Number> column; ///< of the other loops, and itself, with this loop pushed outwards

  /// Where the row, or the column, is zero for all loops of the same component: whether the loop
  /// bounds on the side of its component where the solid is, or on the other, if the other
  /// components were not there.
  bool bounds_inside_component = false, bounds_outside_component = false;

  /// in words, why the numbers mean nothing, because the surface touches or crosses itself; empty
  /// if they do mean something.
  std::string problem;

  /// whether the loop bounds a surface in the solid; `false` if that is not known.
  bool bounds_inside() const { return problem.empty() && row.empty(); }

  /// whether the loop bounds a surface in the space outside the solid; `false` if that is not
  /// known.
  bool bounds_outside() const { return problem.empty() && column.empty(); }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LOOP_LINKING_H
