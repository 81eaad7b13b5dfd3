// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Kernel_traits.h>

namespace CGAL {

namespace Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

A round and straight bore, or the narrowest part of a bore with several diameters.

\tparam Point the point type of a mesh
*/
template <typename Point> struct Round_bore
{
  double diameter; ///< the diameter of the circle through the edges of its wall, in the unit of the
                   ///< coordinates
  Point center;    ///< the midpoint of its axis
  /// the direction of its axis, of length 1. The coordinate of largest absolute value is positive;
  /// if there are several, the first of them.
  typename Kernel_traits<Point>::Kernel::Vector_3 axis;
};

} // namespace Handle_tunnel_loops

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORE_H
