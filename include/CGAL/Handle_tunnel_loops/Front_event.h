// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_FRONT_EVENT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_FRONT_EVENT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The events of the fronts of the initial pass.
enum class Front_event_type {
  SPLIT,   ///< a front splits in two; each part continues in a layer of its own
  MERGE,   ///< two fronts merge and continue in one new layer: a handle
  CLOSING, ///< a front has shrunk to a point
  REST     ///< the field has stalled before it covered the surface, and is restarted
};

/// Returns the name of a type of event, as it appears in reports.
inline const char* front_event_name(Front_event_type type) {
  constexpr std::array<const char*, 4> names = {"split", "merge", "closing", "rest"};
  return names[static_cast<std::size_t>(type)];
}

/// \ingroup PkgHandleTunnelLoopsRef
/// An event of the initial pass (paper, section 4.1). Events of type `REST` occur with
/// `Reference_tag` only.
struct Front_event
{
  /// A front, just before or just after the event.
  struct Front
  {
    /// the layer of the front, which is its row in the matrix of fields; layers are numbered from 1
    /// in the order in which their fronts begin.
    std::size_t layer;
    double length; ///< the length of the front, in the unit of the coordinates
  };

  Front_event_type type;
  std::size_t step;          ///< the time step of the field, from 1; 0 in the region of the seed
  std::size_t vertex;        ///< the index of the vertex of the event, in the caller's numbering
  std::vector<Front> before; ///< the fronts that end
  std::vector<Front> after;  ///< the fronts that begin
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Counts where a mesh is too coarse for an assumption of the paper: that the band of a front is
/// narrow relative to all features that it passes. Such events do not make a result wrong.
struct Field_resolution
{
  /// the number of handles that a front surrounded within one time step. The split and the merge
  /// cannot be seen after such a step, but the order of arrival within the step shows them.
  std::size_t handles_within_steps = 0;
  /// how often the field stalled before it covered the surface.
  std::size_t rests = 0;
  /// the number of vertices that passed the threshold before the front reached them.
  std::size_t early_vertices = 0;
  /// the number of events within the region of a seed, which should be a disk.
  std::size_t events_in_seed_region = 0;

  /// Returns whether all counts are zero.
  bool is_resolved() const {
    return handles_within_steps + rests + early_vertices + events_in_seed_region == 0;
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_FRONT_EVENT_H
