// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_HANDLE_MEASURES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_HANDLE_MEASURES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The largest ball that can be led along some closed curve.
template <typename Point> struct Threaded_ball
{
  double diameter = 0.;     ///< in the unit of the coordinates
  double error = 0.;        ///< the true diameter is not farther from this than that
  Point throat;             ///< where the centre is when the ball has the least room
  std::vector<Point> curve; ///< along which the centre goes, closed; it begins at the throat
};

/// \ingroup PkgHandleTunnelLoopsRef
/// How thick a handle is, and how wide its hole: what `handle_measures()` writes.
template <typename Point> struct Handle_measures
{
  /// the largest ball that goes around the handle in the material.
  std::optional<Threaded_ball<Point>> thickness;

  /// the largest ball that goes through the hole, from outside.
  std::optional<Threaded_ball<Point>> clear_width;

  /// why one of these is missing, in words; empty if none is.
  std::string why;
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_HANDLE_MEASURES_H
