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

#include <cstddef>

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
  Point center;    ///< on its axis, in the middle of its length
  /// the direction of its axis, of length 1. The coordinate of largest absolute value is positive;
  /// if there are several, the first of them.
  typename Kernel_traits<Point>::Kernel::Vector_3 axis;
  /// how far its wall reaches along the axis. A bore that others cut into parts is measured from
  /// end to end.
  double length;
  double deviation;     ///< the largest distance of an edge of its wall to that cylinder, at most
  std::size_t drilling; ///< from 0 on; what is parted by other bores has the same number
};

} // namespace Handle_tunnel_loops

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORE_H
