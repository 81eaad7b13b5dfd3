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

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// Which ways of removing a handle are allowed.
enum class Removal_method {
  CUT,     ///< cut along the handle loop, and both ends closed in the solid
  FILL,    ///< cut along the tunnel loop, and its hole closed on both sides
  CHEAPEST ///< whole if it is like a knob on the surface; or else along the shorter of the two, or
           ///< along the other one if that cannot be
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Which handles are removed, and how: the value of the named parameter `removal_options`. Lengths
/// are in the unit of the coordinates.
struct Removal_options
{
  /// along which loops handles are removed.
  Removal_method method = Removal_method::CHEAPEST;
  /// the genus to be left, summed over the components; by default none.
  std::optional<std::size_t> target_genus;
  /// only handles of a smaller size are removed; by default there is no limit, or that of necks.
  std::optional<double> maximal_length;
  /// only handles are removed whose loop that is tried first lies in this box.
  std::optional<Bbox_3> box;
  /// necks shorter than this are removed; 0 for none.
  double maximal_neck_length = 0.;
  /// the share of the area of its component that each piece has at least that comes off at a neck;
  /// from 0 to 0.5.
  double minimal_piece_share = 0.01;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// How a handle was removed.
enum class Removal_way {
  CUT,  ///< cut along the handle loop, and both ends closed in the solid
  FILL, ///< cut along the tunnel loop, and its hole closed on both sides
  WHOLE ///< the surroundings of both loops taken out, and replaced by one disc
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle that was removed, or a neck. Of handles that were taken out together as a whole, area
/// and volume are shared out equally.
struct Removed_handle
{
  std::size_t pair; ///< the position of its pair among all; of no meaning for a neck
  Removal_way by;   ///< how it was removed
  double length; ///< of the loop that it was removed along, as that was found: it may have been led
                 ///< around other handles since
  double area;   ///< of the caps that took the place of a strip along the loop
  double volume; ///< of the solid taken away; negative if solid was put in
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle that was to be removed and was not, or a neck.
struct Refused_handle
{
  std::size_t pair;   ///< the position of its pair among all; of no meaning for a neck
  double length;      ///< of the loop that was tried first
  std::string reason; ///< in words, for each loop that was tried
};

/// \ingroup PkgHandleTunnelLoopsRef
/// What `CGAL::remove_handles()` has done, or would do. Summed over the components.
struct Removal_report
{
  std::size_t genus_before = 0, genus_after = 0;
  std::size_t components_before = 0, components_after = 0;
  std::vector<Removed_handle> removed; ///< handles
  std::vector<Refused_handle> refused;
  std::vector<Removed_handle> removed_necks; ///< where a piece came off
  std::vector<Refused_handle> refused_necks;
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_REPORT_H
