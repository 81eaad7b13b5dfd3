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
/// The largest ball that can move along a closed curve of some kind.
template <typename Point> struct Threaded_ball
{
  double diameter = 0.;     ///< the diameter, in the unit of the coordinates
  double error = 0.;        ///< an upper bound for the error of the diameter
  Point throat;             ///< the center of the ball at the narrowest place
  std::vector<Point> curve; ///< the closed curve of the center; begins at `throat`
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The thickness of a handle and the clear width of its hole, as `handle_measures()` writes them.
template <typename Point> struct Handle_measures
{
  /// the largest ball that can move around the handle inside the material.
  std::optional<Threaded_ball<Point>> thickness;

  /// the largest ball that can pass through the hole, outside the material.
  std::optional<Threaded_ball<Point>> clear_width;

  /// why a value is missing, as text; empty if both are present.
  std::string why;
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_HANDLE_MEASURES_H
