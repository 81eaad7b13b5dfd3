// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_NEARBY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_NEARBY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/loop_distance.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loops_around_vertex.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/shortened.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Finds loops for handles that have lost theirs: near these, not much longer, and such that they do
not separate the surface. That is what a handle can be removed along, even if nothing is known of
its partner, nor whether it is cut or filled.
*/
class Loops_nearby
{
public:
  explicit Loops_nearby(const Surgery_mesh& mesh)
      : mesh_(mesh) {}

  /// copies of the tasks, of which those are open that were not done and have such a loop now,
  /// apart from all that were found before.
  std::vector<Removal_task> operator()(Execution execution,
                                       const std::vector<Removal_task>& tasks) {
    is_taken_.resize(mesh_.vertex_bound(), 0);
    std::vector<std::size_t> lost;
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(is_lost(tasks[i]))
        lost.push_back(i);
    std::vector<Closed_walk> walks(lost.size());
    const std::size_t number_of_threads = execution.number_of_threads();
    execution.for_ranges(lost.size(), 1 + lost.size() / number_of_threads,
                         [&](std::size_t begin, std::size_t end) {
                           Search search(mesh_);
                           for(std::size_t i = begin; i < end; ++i)
                             walks[i] = find(search, tasks[lost[i]], tasks);
                         });
    std::vector<Removal_task> nearby(tasks.size());
    for(Removal_task& task : nearby)
      task.state = Removal_task::State::KEPT;
    for(std::size_t i = 0; i < lost.size(); ++i)
      if(!walks[i].empty() && is_free(walks[i]))
        nearby[lost[i]] = task(tasks[lost[i]], walks[i]);
    return nearby;
  }

private:
  // What one thread works with.
  struct Search
  {
    explicit Search(const Surgery_mesh& mesh)
        : loops_around(mesh) {}

    Loops_around_vertex loops_around;
    Separation separates;
  };

  // If it may be cut or filled, whatever its new loop is.
  static bool is_lost(const Removal_task& task) {
    return (task.state == Removal_task::State::DAMAGED ||
            task.state == Removal_task::State::REFUSED) &&
           std::all_of(task.choices.begin(), task.choices.end(),
                       [](const Loop_choice& choice) { return choice.is_allowed; });
  }

  Removal_task task(const Removal_task& lost, const Closed_walk& walk) {
    for(Index v : walk)
      is_taken_[v] = 1;
    Removal_task task;
    task.pair = lost.pair;
    task.choices = {{lost.choices.front().type, length(mesh_, walk), places_of(walk)}};
    task.are_types_known = false;
    return task;
  }

  bool is_free(const Closed_walk& walk) const {
    return std::none_of(walk.begin(), walk.end(), [this](Index v) { return is_taken_[v]; });
  }

  // Not much longer ones only where there are no shorter ones. Empty if there is none.
  Closed_walk
  find(Search& search, const Removal_task& task, const std::vector<Removal_task>& tasks) const {
    for(double growth : {1., 1.25, 1.5})
      for(const Loop_choice& lost : task.choices)
        for(Index root : roots(lost))
          for(Closed_walk& walk : walks_around(search, root, growth * lost.length))
            if(walk.size() >= 3 && is_simple(walk) && is_free(walk) &&
               is_nearer_than_kept(walk, task, tasks) &&
               !search.separates(mesh_, sides_of(mesh_, walk)))
              return std::move(walk);
    return {};
  }

  // Some vertices of the surface where a loop was.
  std::vector<Index> roots(const Loop_choice& loop) const {
    constexpr std::size_t most = 4;
    std::vector<Index> left;
    for(const Place_on_edge& place : loop.places)
      if(mesh_.outgoing(place.source) != no_index)
        left.push_back(place.source);
    std::vector<Index> roots;
    for(std::size_t k = 0; k < (std::min)(most, left.size()); ++k)
      roots.push_back(left[k * left.size() / most]);
    return roots;
  }

  std::vector<Closed_walk> walks_around(Search& search, Index root, double most_length) const {
    constexpr std::size_t most_vertices = 1 << 14;
    std::vector<Closed_walk> walks;
    for(const Closed_walk& walk : search.loops_around(root, most_length / 2., most_vertices)) {
      walks.push_back(shortened(mesh_, walk));
      if(length(mesh_, walks.back()) > most_length)
        walks.pop_back();
    }
    return walks;
  }

  // Not to remove another handle instead.
  bool is_nearer_than_kept(const Closed_walk& walk,
                           const Removal_task& task,
                           const std::vector<Removal_task>& tasks) const {
    std::vector<Surgery_mesh::Point> points;
    for(Index v : walk)
      points.push_back(mesh_.point(v));
    const double length_of_walk = length(mesh_, walk);
    const auto distance_from = [&](const Removal_task& other) {
      double least = (std::numeric_limits<double>::infinity)();
      for(const Loop_choice& choice : other.choices)
        least = (std::min)(least, loop_distance(mesh_, points, length_of_walk, choice));
      return least;
    };
    const double distance = distance_from(task);
    return std::none_of(tasks.begin(), tasks.end(), [&](const Removal_task& other) {
      return other.state == Removal_task::State::KEPT && distance_from(other) < distance;
    });
  }

  static std::vector<Place_on_edge> places_of(const Closed_walk& walk) {
    std::vector<Place_on_edge> places;
    for(std::size_t i = 0; i < walk.size(); ++i)
      places.push_back({walk[i], after(walk, i), 0.});
    return places;
  }

  const Surgery_mesh& mesh_;
  std::vector<char> is_taken_; // by vertex, by loops that were found
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_NEARBY_H
