// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_TASK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_TASK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A loop that a handle may be removed along.
struct Loop_choice
{
  Loop_type type;
  double length;
  std::vector<Place_on_edge> places;
  bool is_allowed = true; ///< or only here because it crosses the other one once
};

/// A handle to be removed, or a neck, and what has become of it.
struct Removal_task
{
  static constexpr std::size_t is_neck = (std::numeric_limits<std::size_t>::max)();

  enum class State {
    OPEN,
    REMOVED,
    REFUSED,
    DAMAGED, ///< like REFUSED, but its loops were led around others, or lost by that
    KEPT     ///< a handle that is not to be removed
  };

  std::size_t pair = is_neck;       ///< the number of the pair
  std::vector<Loop_choice> choices; ///< in the order in which they are to be tried
  bool are_types_known = true;      ///< or what is taken away will tell

  /// whether the choices are the two loops of a handle, which cross once; or they are any loops.
  bool has_both_loops() const { return are_types_known && choices.size() == 2; }

  State state = State::OPEN;
  bool is_done() const { return state != State::OPEN; }
  std::vector<std::string> reasons; ///< by choice, why not along this one

  // Of a handle that was removed.
  std::size_t choice = 0;
  bool is_whole = false;  ///< taken out with its surroundings
  double area = 0.;       ///< of the caps
  double volume = 0.;     ///< of what was taken away, or put in if negative
  Index end_of_faces = 0; ///< that were put in: none of a higher number is one of them

  /// was removed together with another one.
  void become_like(const Removal_task& other) {
    state = other.state;
    is_whole = other.is_whole;
    area = other.area;
    volume = other.volume;
    end_of_faces = other.end_of_faces;
  }
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_TASK_H
