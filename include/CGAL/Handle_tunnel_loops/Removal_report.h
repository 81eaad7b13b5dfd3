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

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// Which ways of removing a handle are allowed.
enum class Removal_method {
  CUT,             ///< cut along the handle loop, and both ends closed in the solid
  FILL,            ///< cut along the tunnel loop, and its hole closed on both sides
  SMALLEST_CHANGE, ///< whole if it is like a knob on the surface; or else the one of the two that
                   ///< changes the shape less, or the other one if that cannot be
  CHEAPEST = SMALLEST_CHANGE ///< another name
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Which handles are removed, and how: the value of the named parameter `removal_options`. Lengths
/// are in the unit of the coordinates.
struct Removal_options
{
  /// along which loops handles are removed.
  Removal_method method = Removal_method::SMALLEST_CHANGE;
  /// the same for single handles, by the positions of their pairs among all.
  std::map<std::size_t, Removal_method> methods;
  /// the genus to be left, summed over the components; by default none.
  std::optional<std::size_t> target_genus;
  /// only handles of a smaller size are removed; by default there is no limit, or that of necks.
  std::optional<double> maximal_length;
  /// only handles are removed whose loop that is tried first lies in this box.
  std::optional<Bbox_3> box;
  /// only round bores of at least this diameter are removed; by default handles of any kind. See
  /// `maximal_bore_diameter`.
  std::optional<double> minimal_bore_diameter;
  /// only round bores of at most this diameter are removed. Each of the two limits does without the
  /// other one; 0 for the lower one, or infinity for the upper one, asks for all of them. A bore is
  /// round if a part of its wall is a cylinder: its edges lie within 1 percent of the radius on a
  /// circle, which is that of the diameter, and go around it as those of a hexagon, or denser. Of a
  /// stepped bore, or one with counterbores, the narrowest cylinder counts; slots have no diameter.
  /// Bores are filled, whatever else would be the smallest change.
  std::optional<double> maximal_bore_diameter;
  /// necks shorter than this are removed; 0 for none.
  double maximal_neck_length = 0.;
  /// the share of the area of its component that each piece has at least that comes off at a neck;
  /// from 0 to 0.5.
  double minimal_piece_share = 0.01;
  /// whether only channels are removed: holes through the material from an outer wall to an inner
  /// one, such as leaks, shorter around than necks may be. They are filled, and where all of them
  /// are, the inner wall comes off as a shell of its own, which is what tells them from other
  /// handles and necks: these stay.
  bool only_channels = false;
  /// whether handles are removed even where that is no repair: the manual names the limits.
  bool force = false;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// How a handle was removed.
enum class Removal_way {
  CUT,  ///< cut along the handle loop, and both ends closed in the solid
  FILL, ///< cut along the tunnel loop, and its hole closed on both sides
  WHOLE ///< the surroundings of both loops taken out, and replaced by one disc
};

/// \ingroup PkgHandleTunnelLoopsRef
/// How the shape differs where a handle was removed. Volumes and lengths are in the unit of the
/// coordinates.
struct Shape_change
{
  double volume_removed = 0.; ///< of the solid taken away
  double volume_added = 0.;   ///< of the solid put in
  double cap_area = 0.;       ///< of what is new of the surface
  double cap_ratio = 0.;    ///< the largest area of a cap over that of a circle as long as its rim
  double displacement = 0.; ///< the largest distance of a point of a cap from the old surface
  double burial = 0.; ///< the largest distance from the caps of a point that was taken out with
                      ///< solid; what is buried in solid does not count
  double sharpest_angle = 180.; ///< the smallest dihedral angle at an edge of a cap, in degrees:
                                ///< 180 where it is flat
  double box_growth = 0.;       ///< how far a cap leaves the bounding box of the surface

  /// takes another change into account: volumes and areas are added, of all else the worst counts.
  Shape_change& operator+=(const Shape_change& other) {
    volume_removed += other.volume_removed;
    volume_added += other.volume_added;
    cap_area += other.cap_area;
    cap_ratio = (std::max)(cap_ratio, other.cap_ratio);
    displacement = (std::max)(displacement, other.displacement);
    burial = (std::max)(burial, other.burial);
    sharpest_angle = (std::min)(sharpest_angle, other.sharpest_angle);
    box_growth = (std::max)(box_growth, other.box_growth);
    return *this;
  }
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle that was removed, or a neck. Of handles that were taken out together as a whole, areas
/// and volumes are shared out equally.
struct Removed_handle
{
  std::size_t pair; ///< the position of its pair among all; of no meaning for a neck
  Removal_way by;   ///< how it was removed
  double length; ///< of the loop that it was removed along, as that was found: it may have been led
                 ///< around other handles since; of the longest one of what was taken out whole
  double area;   ///< of the caps that took the place of a strip along the loop
  double volume; ///< of the solid taken away; negative if solid was put in
  Shape_change change = {}; ///< of the shape
  std::size_t patch = 0; ///< the number by which the parameter `face_patch_map` knows its caps: its
                         ///< own, or that of the first of those that were removed together
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

  /// of all that was removed.
  Shape_change change() const {
    Shape_change sum;
    for(const std::vector<Removed_handle>* all : {&removed, &removed_necks})
      for(const Removed_handle& handle : *all)
        sum += handle.change;
    return sum;
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_REPORT_H
