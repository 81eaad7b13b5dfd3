// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVE_FROM_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVE_FROM_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/necks/find_necks.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Handle_removal.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Loops_anew.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Loops_nearby.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/remove_from.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surface_copy.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

inline std::size_t number_with(Removal_task::State state, const std::vector<Removal_task>& tasks) {
  return static_cast<std::size_t>(std::count_if(
      tasks.begin(), tasks.end(), [&](const Removal_task& task) { return task.state == state; }));
}

/// removes handles along other loops nearby, as long as there are any that were not tried.
template <typename Ask>
void remove_along_loops_nearby(Execution execution,
                               Handle_removal& remove,
                               const Surgery_mesh& mesh,
                               std::vector<Removal_task>& tasks,
                               const Ask& ask) {
  Loops_nearby find_nearby(mesh);
  for(;;) {
    std::vector<Removal_task> nearby = find_nearby(execution, tasks);
    if(number_with(Removal_task::State::OPEN, nearby) == 0)
      break;
    remove(nearby, ask);
    for(std::size_t k = 0; k < tasks.size(); ++k)
      if(nearby[k].state == Removal_task::State::REMOVED)
        tasks[k] = std::move(nearby[k]);
  }
}

CGAL_HTL_CORE void remove_from(Execution execution,
                               Surgery_mesh& mesh,
                               std::vector<Removal_task>& tasks,
                               const std::function<void(double)>& ask) {
  using State = Removal_task::State;
  const auto ask_now = [&](std::size_t) {
    ask(double(number_with(State::REMOVED, tasks)) / double(tasks.size()));
  };
  Handle_removal remove(execution, mesh);
  for(std::size_t before = 0;; before = number_with(State::REMOVED, tasks)) {
    remove(tasks, ask_now);
    remove_along_loops_nearby(execution, remove, mesh, tasks, ask_now);
    if(number_with(State::DAMAGED, tasks) == 0 || number_with(State::REMOVED, tasks) == before)
      break;
    Loops_anew(execution, mesh).give_to(tasks);
  }
  for(Removal_task& task : tasks)
    if(task.state == State::DAMAGED)
      task.state = State::REFUSED;
}

CGAL_HTL_CORE std::vector<Removal_task>
remove_necks_from(Execution execution, Surgery_mesh& mesh, const Removal_options& wanted) {
  const Surface_copy copy(mesh);
  std::vector<Removal_task> tasks;
  for(const auto& neck :
      find_necks(execution, copy.mesh(), copy.mesh().points(), get(vertex_index, copy.mesh()),
                 Surgery_mesh::Kernel(), wanted.maximal_neck_length, wanted.minimal_piece_share))
  {
    tasks.emplace_back();
    tasks.back().are_types_known = false;
    tasks.back().choices.push_back({Loop_type::HANDLE, neck.length, copy.places(neck.loop)});
  }
  Handle_removal(execution, mesh)(tasks, [](std::size_t) {});
  return tasks;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVE_FROM_IMPL_H
