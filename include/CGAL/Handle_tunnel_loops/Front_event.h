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
/// What can happen to the fronts of the initial pass.
enum class Front_event_type {
  SPLIT,   ///< a front parts in two; each goes on in a layer of its own
  MERGE,   ///< two fronts meet and go on in one new layer: a handle
  CLOSING, ///< a front has shrunk to a point
  REST     ///< the field has come to rest before all is covered, and is pushed on
};

/// the name of a type of event, as it stands in reports.
inline const char* front_event_name(Front_event_type type) {
  constexpr std::array<const char*, 4> names = {"split", "merge", "closing", "rest"};
  return names[static_cast<std::size_t>(type)];
}

/// \ingroup PkgHandleTunnelLoopsRef
/// An event of the initial pass (paper, section 4.1). A field has rests as events with
/// `Reference_tag` only.
struct Front_event
{
  /// A front, at the moment before or after the event.
  struct Front
  {
    /// the row of the matrix of fields in which the front lies; rows are numbered from 1 in the
    /// order in which their fronts begin.
    std::size_t layer;
    double length; ///< in the unit of the coordinates
  };

  Front_event_type type;
  std::size_t step;          ///< the time step of the field, from 1; 0 in the region of the seed
  std::size_t vertex;        ///< index of the vertex at which it happens, in the caller's numbering
  std::vector<Front> before; ///< the fronts concerned that end
  std::vector<Front> after;  ///< those that begin
};

/// \ingroup PkgHandleTunnelLoopsRef
/// Where a mesh is too coarse for what the paper takes for granted: that the band is narrow against
/// everything that it passes. None of this makes an answer wrong.
struct Field_resolution
{
  /// handles that a front went all around in one time step, so that it cannot be seen after the
  /// step that it had split and its parts had met. The order of arrival within the step shows it.
  std::size_t handles_within_steps = 0;
  /// how often the field came to rest before all was covered.
  std::size_t rests = 0;
  /// vertices that passed the threshold before the front had come to them.
  std::size_t early_vertices = 0;
  /// events within the region of a seed, which should be a disc.
  std::size_t events_in_seed_region = 0;

  /// whether nothing of that kind happened.
  bool is_resolved() const {
    return handles_within_steps + rests + early_vertices + events_in_seed_region == 0;
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_FRONT_EVENT_H
