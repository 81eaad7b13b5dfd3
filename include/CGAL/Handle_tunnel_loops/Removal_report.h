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
/// The methods of removing handles.
enum class Removal_method {
  CUT,             ///< cut along the handle loop; both ends are closed inside the solid
  FILL,            ///< cut along the tunnel loop; the hole is closed on both sides
  SMALLEST_CHANGE, ///< take out handles that protrude from a nearly flat region; cut or fill all
                   ///< others, whichever changes the shape less, or else whichever is possible
  CHEAPEST = SMALLEST_CHANGE ///< another name of `SMALLEST_CHANGE`
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The options of a removal: the value of the named parameter `removal_options`. Lengths are in the
/// unit of the coordinates.
struct Removal_options
{
  /// the method of removal.
  Removal_method method = Removal_method::SMALLEST_CHANGE;
  /// the method for single handles, by the positions of their pairs; overrides `method`.
  std::map<std::size_t, Removal_method> methods;
  /// the genus at which to stop, summed over the components; by default, all handles are removed.
  std::optional<std::size_t> target_genus;
  /// if set, only handles of a smaller size are removed. By default, there is no limit, except that
  /// of necks if `maximal_neck_length` is set.
  std::optional<double> maximal_length;
  /// if set, only handles are removed whose loop that is tried first lies in this box.
  std::optional<Bbox_3> box;
  /// if set, only round bores of at least this diameter are removed; see `maximal_bore_diameter`.
  std::optional<double> minimal_bore_diameter;
  /// if set, only round bores of at most this diameter are removed. You can set either limit
  /// without the other. Set the lower limit to 0, or the upper one to infinity, to remove all round
  /// bores. A bore is round if a part of its wall is a cylinder: its edges lie on a circle up to 1
  /// percent of the radius, spaced at least as densely as those of a hexagon. The diameter of the
  /// bore is that of this circle. For a stepped bore, or a bore with counterbores, the narrowest
  /// cylinder counts. Slots have no diameter. Bores are always filled, even if another way would
  /// change the shape less.
  std::optional<double> maximal_bore_diameter;
  /// necks shorter than this are removed; 0 removes none.
  double maximal_neck_length = 0.;
  /// the minimal area of each component that is split off at a neck, as a fraction of the area of
  /// the component before; in [0, 0.5].
  double minimal_piece_share = 0.01;
  /// whether only channels are removed: holes through the material from an outer wall to an inner
  /// wall, such as leaks, whose loops are shorter than `maximal_neck_length`. Channels are filled.
  /// When all of them are filled, the inner wall becomes a shell of its own, which distinguishes
  /// channels from other handles and necks. These are not removed.
  bool only_channels = false;
  /// whether to remove handles even if the removal is not a valid repair; see
  /// `CGAL::remove_handles()` for the conditions.
  bool force = false;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The way in which a handle was removed.
enum class Removal_way {
  CUT,  ///< cut along the handle loop; both ends are closed inside the solid
  FILL, ///< cut along the tunnel loop; the hole is closed on both sides
  WHOLE ///< a disk replaces the surroundings of both loops; it plugs a hole if solid was added
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The change of the shape where a handle was removed. Lengths, areas and volumes are in the unit
/// of the coordinates.
struct Shape_change
{
  double volume_removed = 0.; ///< the volume removed from the solid
  double volume_added = 0.;   ///< the volume added to the solid
  double cap_area = 0.;       ///< the area of the new surface
  double cap_ratio = 0.;    ///< the largest area of a cap, relative to a circle of its rim's length
  double displacement = 0.; ///< the largest distance of a point of a cap to the old surface
  double burial = 0.; ///< the largest distance to the caps of a point that was removed together
                      ///< with solid; points that are now inside the solid do not count
  double sharpest_angle = 180.; ///< the smallest dihedral angle at an edge of a cap, in degrees;
                                ///< 180 if it is flat
  double box_growth = 0.;       ///< the distance by which a cap leaves the old bounding box
  std::size_t crossings = 0;    ///< how many more pairs of faces intersect; 0 unless forced. Of
                                ///< handles removed together, the first one has them all

  /// Returns whether a cap leaves a sharp edge, such as that of a tooth: a fold by more than 100
  /// degrees, as parts are full of right angles.
  bool has_sharp_edge() const { return sharpest_angle < 80.; }

  /// Adds another change: volumes, areas and numbers are summed, and the worst of all other values
  /// is kept.
  Shape_change& operator+=(const Shape_change& other) {
    volume_removed += other.volume_removed;
    volume_added += other.volume_added;
    cap_area += other.cap_area;
    cap_ratio = (std::max)(cap_ratio, other.cap_ratio);
    displacement = (std::max)(displacement, other.displacement);
    burial = (std::max)(burial, other.burial);
    sharpest_angle = (std::min)(sharpest_angle, other.sharpest_angle);
    box_growth = (std::max)(box_growth, other.box_growth);
    crossings += other.crossings;
    return *this;
  }
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle or a neck that was removed. Handles that were taken out together share areas and
/// volumes equally.
struct Removed_handle
{
  std::size_t pair; ///< the position of its pair among all pairs; meaningless for a neck
  Removal_way by;   ///< how it was removed
  double length;    ///< the length of the loop of the removal as it was found; it may have been
                    ///< rerouted since. If taken out whole: the length of the longest loop
  double area;      ///< the area of the caps that replaced a strip along the loop
  double volume;    ///< the volume removed from the solid; negative if solid was added
  Shape_change change = {}; ///< the change of the shape
  std::size_t patch = 0; ///< the number of its caps in `face_patch_map`: its own number, or that of
                         ///< the first of the handles that were removed together
};

/// \ingroup PkgHandleTunnelLoopsRef
/// A handle or a neck that was selected for removal but not removed.
struct Refused_handle
{
  std::size_t pair;   ///< the position of its pair among all pairs; meaningless for a neck
  double length;      ///< the length of the loop that was tried first
  std::string reason; ///< the reason as text, for each loop that was tried
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The result of `CGAL::remove_handles()`, also of a dry run. Numbers are summed over the
/// components.
struct Removal_report
{
  /// the genus before and after the removal.
  std::size_t genus_before = 0, genus_after = 0;
  /// the number of connected components before and after the removal.
  std::size_t components_before = 0, components_after = 0;
  std::vector<Removed_handle> removed;       ///< handles that were removed
  std::vector<Refused_handle> refused;       ///< handles that were refused
  std::vector<Removed_handle> removed_necks; ///< necks at which a component was split off
  std::vector<Refused_handle> refused_necks; ///< necks that were refused

  /// Returns the change of the shape by all removals.
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
