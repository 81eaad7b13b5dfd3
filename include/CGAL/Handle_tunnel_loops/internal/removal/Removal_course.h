// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_COURSE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_COURSE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Region_layout.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_proposal.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Way_of_removal.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Detour.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/led_off_boundary.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/shortened.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What is tried of a task, one way after the other.
class Removal_course
{
public:
  Removal_course(const Surgery_mesh& mesh, Removal_task& task)
      : task_(&task)
      , ways_(ways_of_removal(task))
      , is_damaged_(task.choices.size(), 0)
      , separates_(task.choices.size(), 0) {
    task.reasons.assign(task.choices.size(), std::string());
    for(const Loop_choice& choice : task.choices)
      add_walk(mesh, simple_part(led_off_boundary(mesh, walk_beside(mesh, choice.places))));
  }

  Removal_task& task() const { return *task_; }

  bool is_done() const { return task_->is_done(); }

  /// by choice; those with less than three vertices are none.
  const std::vector<Closed_walk>& walks() const { return walks_; }

  const Way_of_removal& way() const { return ways_[next_]; }

  /// of the loop of the present way; empty if that has none.
  Closed_walk partner() const {
    return task_->has_both_loops() ? walks_[1 - way().choice] : Closed_walk();
  }

  /// of the present way; nothing if there is no way left.
  const std::optional<Removal_proposal>& proposal() const { return proposal_; }

  /// the loop of the present way wants to keep its place.
  void reserve(Region_layout& layout) {
    reserved_ = walks_[way().choice];
    make_set(reserved_);
    layout.reserve(reserved_);
  }

  /// goes on to the first way, from the present one on, that there is.
  void propose(const Surgery_mesh& mesh, const Region_layout& layout) {
    if(proposal_ && !is_narrow_ && proposal_->is_up_to_date(mesh))
      return;
    is_narrow_ = false;
    proposal_.reset();
    while(!is_done()) {
      if(const char* why = why_not_at_all())
        fail(why);
      else if((proposal_ = layout.proposal(way(), walks_, reserved_)))
        return;
      else
        fail(is_on_boundary(mesh, walks_[way().choice]) ? "the loop comes to the boundary"
                                                        : "the mesh is too coarse along the loop",
             false);
    }
  }

  /// the present way once more, with room for the regions that are claimed by now.
  void propose_again(const Region_layout& layout) {
    is_narrow_ = true;
    proposal_ = layout.proposal(way(), walks_, reserved_);
  }

  /// gives the present way up, and the task if that is the last one.
  void fail(const char* why, bool is_last_word = true) {
    std::string& reason = task_->reasons[way().choice];
    if(is_last_word || reason.empty())
      reason = why;
    proposal_.reset();
    if(++next_ == ways_.size())
      task_->state = is_any_damaged() ? Removal_task::State::DAMAGED : Removal_task::State::REFUSED;
  }

  /// gives the present way up, and all others at its loop: caps that cross themselves do so
  /// wherever they lie there.
  void fail_at_loop() {
    if(const Way_of_removal failed = way(); failed.is_at_loop())
      ways_.erase(std::remove_if(ways_.begin() + static_cast<std::ptrdiff_t>(next_) + 1,
                                 ways_.end(),
                                 [&](const Way_of_removal& way) {
                                   return way.choice == failed.choice && way.is_at_loop();
                                 }),
                  ways_.end());
    fail("the caps would meet each other");
  }

  /// gives the loop of the present way up: all strips along it separate the surface.
  void fail_along_loop() {
    separates_[way().choice] = 1;
    fail(separates_the_surface);
  }

  /// leads a loop around what has taken the place of another handle. It is given up if it comes to
  /// a vertex twice then, or becomes much longer. Returns whether it was led.
  bool lead_around(const Surgery_mesh& mesh, const Detour& detour, std::size_t choice) {
    constexpr double most_growth = 1.5;
    Closed_walk& walk = walks_[choice];
    if(walk.size() < 3 || is_intact(mesh, walk))
      return false;
    walk = led_off_boundary(mesh, shortened(mesh, detour.around(walk)));
    if(!is_simple(walk) || length(mesh, walk) > most_growth * lengths_[choice])
      walk.clear();
    is_damaged_[choice] = true;
    return !walk.empty();
  }

private:
  void add_walk(const Surgery_mesh& mesh, Closed_walk walk) {
    lengths_.push_back(length(mesh, walk));
    walks_.push_back(std::move(walk));
  }

  // A way that takes one loop, or both.
  const char* why_not_at_all() const {
    if(separates_[way().choice] && !way().takes_both_loops())
      return separates_the_surface;
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if((i == way().choice || way().takes_both_loops()) && walks_[i].size() < 3)
        return is_damaged_[i] ? "another handle was removed across the loop"
                              : "the loop is not simple";
    return nullptr;
  }

  bool is_any_damaged() const {
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if(is_damaged_[i] && task_->choices[i].is_allowed)
        return true;
    return false;
  }

  static constexpr const char* separates_the_surface = "the loop separates the surface";

  Removal_task* task_;
  std::vector<Closed_walk> walks_;
  std::vector<double> lengths_; // of these at first
  std::vector<Way_of_removal> ways_;
  std::vector<char> is_damaged_; // by choice, also if it could be led around
  std::vector<char> separates_;  // by choice
  std::size_t next_ = 0;
  std::vector<Index> reserved_; // in ascending order
  std::optional<Removal_proposal> proposal_;
  bool is_narrow_ = false; // because of regions of the round
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_COURSE_H
