// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_TASK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_TASK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Caps_in_vain.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loop_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Region_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A handle to be removed, or a neck, and what has become of it.
struct Removal_task
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  enum class State {
    OPEN,
    REMOVED,
    REFUSED,
    DAMAGED, ///< like REFUSED, but its loops were led around others, or lost by that
    KEPT     ///< a handle that is not to be removed
  };

  std::size_t pair = none;             ///< its number; none for a neck
  std::vector<Loop_choice> choices;    ///< in the order in which they are to be tried
  bool are_types_known = true;         ///< or what is taken away will tell
  bool are_given_loops = true;         ///< or found on the surface as it has become
  bool comes_first = false;            ///< before all others that do not
  std::optional<Region_choice> region; ///< that it was removed with, or was before

  bool is_of_neck() const { return pair == none; }

  /// whether the choices are only near the loops of a handle that could not be removed.
  bool are_loops_nearby() const { return !are_types_known && !is_of_neck(); }

  /// whether the choices are the two loops of a handle, which cross once; or they are any loops.
  bool has_both_loops() const { return are_types_known && choices.size() == 2; }

  std::size_t longest_choice() const {
    return std::max_element(
               choices.begin(), choices.end(),
               [](const Loop_choice& a, const Loop_choice& b) { return a.length < b.length; }) -
           choices.begin();
  }

  State state = State::OPEN;
  bool is_done() const { return state != State::OPEN; }
  bool has_failed() const { return state == State::REFUSED || state == State::DAMAGED; }

  /// whether it may be removed still, if only with others.
  bool is_left() const { return !is_done() || has_failed(); }

  /// what was tried with it: of the same handle, also as another task or on another copy of the
  /// surface.
  std::shared_ptr<std::vector<Caps_in_vain>> in_vain =
      std::make_shared<std::vector<Caps_in_vain>>();

  /// of another copy, that which was changed there is not known here.
  void forget_what_is_not_of(const Surgery_mesh& mesh) {
    in_vain->erase(std::remove_if(in_vain->begin(), in_vain->end(),
                                  [&](const Caps_in_vain& tried) { return !tried.holds(mesh); }),
                   in_vain->end());
  }

  // Of a handle that could not be removed.
  std::vector<std::string> reasons; ///< by choice, why not along this one
  Box<3> reach = Box<3>::empty();   ///< holds its loops, and all that it was tried with
  bool is_far_reaching = false;     ///< what is elsewhere has a say, too
  bool is_hindered = false;         ///< something there is not as it was at first

  /// the handle was tried as another task.
  void note_tries(const Removal_task& other) {
    reach.extend(other.reach);
    is_far_reaching |= other.is_far_reaching;
  }

  // Of a handle that was removed.
  std::size_t choice = 0;
  bool is_whole = false;  ///< taken out with its surroundings
  double length = 0.;     ///< that distances are measured by
  Shape_change change;    ///< its share, if others were removed with it
  Index end_of_faces = 0; ///< that were put in: none of a higher number is one of them

  /// was removed together with another one.
  void become_like(const Removal_task& other) {
    CGAL_precondition(is_left() && other.state == State::REMOVED);
    state = other.state;
    is_whole = other.is_whole;
    for(std::size_t i = 0; i < choices.size(); ++i)
      if(choices[i].type == other.choices[other.choice].type)
        choice = i;
    length = other.length;
    change = other.change;
    change.crossings = 0; // which are told once
    end_of_faces = other.end_of_faces;
  }

  /// lengths in another unit.
  void divide_lengths(double unit) {
    for(Loop_choice& loop : choices)
      loop.length /= unit;
    length /= unit;
    const double area = unit * unit, volume = area * unit;
    change.volume_removed /= volume;
    change.volume_added /= volume;
    change.cap_area /= area;
    change.displacement /= unit;
    change.burial /= unit;
    change.box_growth /= unit;
  }

  // ---- for the report

  Removed_handle removed() const {
    CGAL_precondition(state == State::REMOVED);
    const Removal_way along_loop =
        choices[choice].type == Loop_type::HANDLE ? Removal_way::CUT : Removal_way::FILL;
    return {pair,
            is_whole ? Removal_way::WHOLE : along_loop,
            length,
            change.cap_area,
            change.volume_removed - change.volume_added,
            change};
  }

  Refused_handle refused() const {
    CGAL_precondition(state == State::REFUSED);
    std::string why;
    for(std::size_t i = 0; i < choices.size(); ++i)
      if(choices[i].is_allowed)
        why += std::string(i == 0 ? "" : "; ") +
               (choices[i].type == Loop_type::HANDLE ? "cut: " : "fill: ") + reasons[i];
    return {pair, choices.front().length, why};
  }
};

/// how many are not done, or could not be.
inline std::size_t number_left(const std::vector<Removal_task>& tasks) {
  return static_cast<std::size_t>(std::count_if(
      tasks.begin(), tasks.end(), [](const Removal_task& task) { return task.is_left(); }));
}

inline std::size_t number_with(Removal_task::State state, const std::vector<Removal_task>& tasks) {
  return static_cast<std::size_t>(std::count_if(
      tasks.begin(), tasks.end(), [&](const Removal_task& task) { return task.state == state; }));
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_TASK_H
