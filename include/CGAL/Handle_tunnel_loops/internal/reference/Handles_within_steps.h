// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_HANDLES_WITHIN_STEPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_HANDLES_WITHIN_STEPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
The number of handles that cannot be seen by looking at the fronts after each time step.

Fronts that are related by the events of a step, k of them before it, have merged to k - 1 handles
as far as can be seen. If there were more merges, a front has split and its parts have met again in
one step.
*/
class Handles_within_steps
{
public:
  explicit Handles_within_steps(const std::vector<Front_event>& events) {
    for(const Front_event& event : events) {
      if(event.step != step_)
        end_step();
      step_ = event.step;
      add(event);
    }
    end_step();
  }

  std::size_t number() const { return number_; }

private:
  // Fronts that are related; groups that were joined stay where they are, but empty.
  struct Group
  {
    std::size_t fronts_before = 0, merges = 0;
    std::vector<std::size_t> layers;
  };

  void end_step() {
    for(const Group& group : groups_)
      if(!group.layers.empty())
        number_ += group.merges + 1 - group.fronts_before;
    groups_.clear();
    group_of_layer_.clear();
  }

  void add(const Front_event& event) {
    if(event.before.empty())
      return;
    const std::size_t group = group_of(event.before.front().layer);
    for(const Front_event::Front& front : event.before)
      join(group, group_of(front.layer));
    for(const Front_event::Front& front : event.after)
      put(front.layer, group);
    groups_[group].merges += event.type == Front_event_type::MERGE;
  }

  std::size_t group_of(std::size_t layer) {
    const auto it = group_of_layer_.find(layer);
    if(it != group_of_layer_.end())
      return it->second;
    groups_.emplace_back();
    groups_.back().fronts_before = 1;
    put(layer, groups_.size() - 1);
    return groups_.size() - 1;
  }

  void put(std::size_t layer, std::size_t group) {
    group_of_layer_[layer] = group;
    groups_[group].layers.push_back(layer);
  }

  void join(std::size_t group, std::size_t other) {
    if(group == other)
      return;
    groups_[group].fronts_before += groups_[other].fronts_before;
    groups_[group].merges += groups_[other].merges;
    for(std::size_t layer : groups_[other].layers)
      put(layer, group);
    groups_[other] = Group();
  }

  std::size_t number_ = 0, step_ = 0;
  std::vector<Group> groups_; // of the present step
  std::map<std::size_t, std::size_t> group_of_layer_;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_HANDLES_WITHIN_STEPS_H
