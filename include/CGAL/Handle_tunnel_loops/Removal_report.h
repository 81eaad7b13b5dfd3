// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_REPORT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_REPORT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// How handles are removed.
enum class Removal_method {
  CUT,     ///< cut along the handle loop, and both ends closed in the solid
  FILL,    ///< cut along the tunnel loop, and its hole closed on both sides
  CHEAPEST ///< along the shorter of the two, or along the other one if that cannot be
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle that was removed.
struct Removed_handle
{
  std::size_t pair; ///< the position of its pair among all
  Loop_type along;  ///< the loop that it was removed along: the handle cut, or the tunnel filled
  double length;    ///< of that loop
  double area;      ///< of the caps that took the place of a strip along the loop
  double volume;    ///< of the solid taken away; negative if solid was put in
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle that was to be removed and was not.
struct Refused_handle
{
  std::size_t pair;   ///< the position of its pair among all
  std::string reason; ///< in words, for each loop that was tried
};

/// \ingroup PkgHandleTunnelLoopsRef
/// What `CGAL::remove_handles()` has done, or would do. Summed over the components.
struct Removal_report
{
  std::size_t genus_before = 0, genus_after = 0;
  std::size_t components_before = 0, components_after = 0;
  std::vector<Removed_handle> removed;
  std::vector<Refused_handle> refused;
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_REPORT_H
