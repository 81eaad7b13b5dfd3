// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOPS_ANEW_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOPS_ANEW_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Loops_on_arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loop_distance.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loops_around_vertex.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How many loops are looked for near others, and how long they may be.
struct Nearby_search
{
  std::size_t most_loops = 8; ///< of one handle, but for those that come with them
  std::size_t enough = 4;     ///< at a time
  std::size_t most_roots = 4; ///< on each loop that is lost
  double most_growth = 1.5;   ///< of its length

  static constexpr Nearby_search wide() { return {32, 8, 8, 2.}; }
};

/*!
Finds loops for handles that have lost theirs: near these, not much longer, and such that they do
not separate the surface. That is what a handle can be removed along, even if nothing is known of
its partner, nor whether it is cut or filled.
*/
class Loops_nearby
{
public:
  Loops_nearby(const Surgery_mesh& mesh, const Nearby_search& wanted)
      : mesh_(mesh)
      , wanted_(wanted)
      , searches_([&mesh] { return std::make_unique<Search>(mesh); }) {}

  /// copies of the tasks, of which those are open that were not done and have such loops now, apart
  /// from all that were found before.
  std::vector<Removal_task> operator()(Execution execution,
                                       const std::vector<Removal_task>& tasks) {
    is_taken_.resize(mesh_.vertex_bound(), 0);
    lost_.resize(tasks.size());
    std::vector<std::size_t> lost;
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(is_lost(tasks[i]) && lost_[i].number_found < wanted_.most_loops) {
        lost_[i].loops = tasks[i].choices;
        lost.push_back(i);
      }
    std::vector<std::vector<Closed_walk>> walks(lost.size());
    for_each_index(
        execution, lost.size(),
        [&](std::size_t i) { walks[i] = find(*searches_.borrow(), lost[i], tasks); }, 1);
    std::vector<Removal_task> nearby(tasks.size());
    for(Removal_task& task : nearby)
      task.state = Removal_task::State::KEPT;
    for(std::size_t i = 0; i < lost.size(); ++i) {
      lost_[lost[i]].number_found += walks[i].empty() ? wanted_.most_loops : walks[i].size();
      give(walks[i], tasks[lost[i]], nearby[lost[i]]);
    }
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

  // What is known of a task.
  struct Lost
  {
    std::vector<Loop_choice> loops; // empty if it never was
    std::size_t number_found = 0;   // of new ones; the most if nothing more is found
  };

  // If it may be cut or filled, whatever its new loop is.
  static bool is_lost(const Removal_task& task) {
    return task.has_failed() &&
           std::all_of(task.choices.begin(), task.choices.end(),
                       [](const Loop_choice& choice) { return choice.is_allowed; });
  }

  // Those of the walks that are new.
  void give(const std::vector<Closed_walk>& walks, const Removal_task& lost, Removal_task& task) {
    for(const Closed_walk& walk : walks)
      if(is_new(walk)) {
        task.choices.push_back({lost.choices.front().type, length(mesh_, walk), places_of(walk)});
        for(Index v : walk)
          is_taken_[v] = 1;
      }
    if(task.choices.empty())
      return;
    task.state = Removal_task::State::OPEN;
    task.pair = lost.pair;
    task.in_vain = lost.in_vain;
    task.are_types_known = task.are_given_loops = false;
  }

  // It may cross others, but not go along them.
  bool is_new(const Closed_walk& walk) const {
    return 2 * std::count_if(walk.begin(), walk.end(), [this](Index v) { return is_taken_[v]; }) <
           static_cast<std::ptrdiff_t>(walk.size());
  }

  // Near the loops of the handle; or, as it may have been removed along a loop that was found for
  // another one, near the loops of that.
  std::vector<Closed_walk>
  find(Search& search, std::size_t task, const std::vector<Removal_task>& tasks) const {
    const std::vector<Loop_choice>& lost = lost_[task].loops;
    std::vector<Closed_walk> found = find_as_long(search, lost, tasks);
    for(std::size_t other : others_removed(task, tasks))
      if(found.empty())
        found = find_as_long(search, lost_[other].loops, tasks);
    return !found.empty() ? found : find_longer(search, lost, tasks);
  }

  // No longer than some loops, near one of them.
  std::vector<Closed_walk> find_as_long(Search& search,
                                        const std::vector<Loop_choice>& lost,
                                        const std::vector<Removal_task>& tasks) const {
    for(const Loop_choice& loop : lost)
      for(Index root : roots(loop)) {
        std::vector<Closed_walk> found =
            useful(search, walks_around(search, root, loop.length), lost, tasks);
        if(!found.empty())
          return found;
      }
    return {};
  }

  // Not much longer ones, the shortest ones near all of them.
  std::vector<Closed_walk> find_longer(Search& search,
                                       const std::vector<Loop_choice>& lost,
                                       const std::vector<Removal_task>& tasks) const {
    std::vector<Closed_walk> walks;
    for(const Loop_choice& loop : lost)
      for(Index root : roots(loop))
        for(Closed_walk& walk : walks_around(search, root, wanted_.most_growth * loop.length))
          walks.push_back(std::move(walk));
    std::stable_sort(walks.begin(), walks.end(),
                     [this](const Closed_walk& a, const Closed_walk& b) {
                       return length(mesh_, a) < length(mesh_, b);
                     });
    return useful(search, std::move(walks), lost, tasks);
  }

  // The nearest ones of those that had lost their loops.
  std::vector<std::size_t> others_removed(std::size_t task,
                                          const std::vector<Removal_task>& tasks) const {
    constexpr std::size_t most = 3;
    std::vector<std::pair<double, std::size_t>> others;
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(!lost_[i].loops.empty() && tasks[i].state == Removal_task::State::REMOVED)
        others.push_back(
            {CGAL::squared_distance(place(lost_[task].loops), place(lost_[i].loops)), i});
    std::sort(others.begin(), others.end());
    std::vector<std::size_t> nearest;
    for(std::size_t k = 0; k < (std::min)(most, others.size()); ++k)
      nearest.push_back(others[k].second);
    return nearest;
  }

  Surgery_mesh::Point place(const std::vector<Loop_choice>& loops) const {
    return point_at(mesh_, loops.front().places.front());
  }

  // The first ones of some walks that are of use.
  std::vector<Closed_walk> useful(Search& search,
                                  std::vector<Closed_walk> walks,
                                  const std::vector<Loop_choice>& lost,
                                  const std::vector<Removal_task>& tasks) const {
    std::vector<Closed_walk> found;
    for(std::size_t i = 0; i < walks.size() && found.size() < wanted_.enough; ++i)
      if(walks[i].size() >= 3 && is_simple(walks[i]) && is_new(walks[i]) &&
         is_nearer_than_kept(walks[i], lost, tasks) && !separates(search, walks[i]))
        found.push_back(std::move(walks[i]));
    return found;
  }

  // Also if there is no curve beside it.
  bool separates(Search& search, const Closed_walk& walk) const {
    const auto curve = Curve_off_vertices::beside(mesh_, places_of(walk));
    return !curve || search.separates(mesh_, cut_along(mesh_, *curve));
  }

  // Some vertices of the surface where a loop was.
  std::vector<Index> roots(const Loop_choice& loop) const {
    const std::size_t most = wanted_.most_roots;
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
                           const std::vector<Loop_choice>& lost,
                           const std::vector<Removal_task>& tasks) const {
    std::vector<Surgery_mesh::Point> points;
    for(Index v : walk)
      points.push_back(mesh_.point(v));
    const Loop_distance distance_of_walk(points, length(mesh_, walk));
    const auto distance_from = [&](const std::vector<Loop_choice>& loops) {
      double least = (std::numeric_limits<double>::infinity)();
      for(const Loop_choice& loop : loops)
        least = (std::min)(least, distance_of_walk(mesh_, loop));
      return least;
    };
    const double distance = distance_from(lost);
    return std::none_of(tasks.begin(), tasks.end(), [&](const Removal_task& other) {
      return other.state == Removal_task::State::KEPT && distance_from(other.choices) < distance;
    });
  }

  const Surgery_mesh& mesh_;
  const Nearby_search wanted_;
  Workspace_pool<Search> searches_;
  std::vector<Lost> lost_;     // by task
  std::vector<char> is_taken_; // by vertex, by loops that were found
};

/// Finds the loops of a mesh under surgery, as it is by now.
class Loops_under_surgery
{
public:
  struct Loop : Loop_choice
  {
    std::vector<Surgery_mesh::Point> points;
  };
  struct Pair
  {
    Loop handle, tunnel;

    const Loop& loop(Loop_type type) const { return type == Loop_type::HANDLE ? handle : tunnel; }
  };

  explicit Loops_under_surgery(const Surgery_mesh& mesh)
      : mesh_(mesh)
      , graph_(mesh) {}

  std::vector<Pair> find(Execution execution) const {
    const Prepared_surface<Surgery_graph, Surgery_graph::Point_map> prepared(
        execution, graph_, Surgery_graph::Vertex_index_map(), graph_.point());
    Loop_request wanted;
    wanted.make_passes = execution.is_parallel() ? &make_passes<Threads_if_available_tag>
                                                 : &make_passes<Sequential_tag>;
    const std::vector<Flat_surface::Point> coordinates = prepared.coordinates(execution);
    Loops_on_arrays loops(coordinates);
    loops.find(execution, prepared.mesh, wanted);
    const Flat_surface surface(prepared.mesh, coordinates);
    std::vector<Pair> pairs;
    for(const Flat_surface::Pair& pair : surface.pairs(loops.pairs()))
      pairs.push_back({loop_on_mesh(surface, pair.handle()), loop_on_mesh(surface, pair.tunnel())});
    return pairs;
  }

private:
  Loop loop_on_mesh(const Flat_surface& surface, const Flat_surface::Loop& flat_loop) const {
    Loop loop{loop_choice(flat_loop, surface.mesh(), surface.vertex_index()), {}};
    for(const Place_on_edge& place : loop.places)
      loop.points.push_back(point_at(mesh_, place));
    return loop;
  }

  const Surgery_mesh& mesh_;
  const Surgery_graph graph_;
};

/// Finds the loops of a surface from which some handles were removed, and which of them are those
/// of handles that are still there: they lie where these had theirs.
class Loops_anew
{
  using Pair = Loops_under_surgery::Pair;

public:
  Loops_anew(Execution execution, const Surgery_mesh& mesh)
      : mesh_(mesh)
      , pairs_(Loops_under_surgery(mesh).find(execution)) {
    for(const Pair& pair : pairs_)
      distances_.push_back({Loop_distance(pair.handle.points, pair.handle.length),
                            Loop_distance(pair.tunnel.points, pair.tunnel.length)});
  }

  /// gives new loops to those that could not be removed, and has the smallest come first among
  /// them. Those that are not found stay as they are.
  void give_to(std::vector<Removal_task>& tasks) const {
    std::vector<std::size_t> old;
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(tasks[i].state != Removal_task::State::REMOVED && !tasks[i].is_of_neck())
        old.push_back(i);
    Assignment done{std::vector<std::size_t>(tasks.size(), none),
                    std::vector<char>(pairs_.size(), 0)};
    give_nearest(tasks, old, 1., done);
    if(old.size() == pairs_.size()) // all handles are known: the last ones have nothing else left
      give_nearest(tasks, old, infinite, done);
    sort(tasks, done);
  }

private:
  static constexpr double infinite = (std::numeric_limits<double>::infinity)();
  static constexpr std::size_t none = Removal_task::none;

  // The pairs that tasks have by now, by the numbers of these; and which pairs are taken.
  struct Assignment
  {
    std::vector<std::size_t> pair;
    std::vector<char> is_taken;
  };

  // Those that are open, as a selection has them in order: the places of others stay.
  static void sort(std::vector<Removal_task>& tasks, const Assignment& done) {
    std::vector<std::tuple<double, std::size_t, std::size_t>> open;
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(!tasks[i].is_done())
        open.push_back({tasks[i].choices.front().length, done.pair[i], i});
    std::vector<Removal_task> sorted;
    std::sort(open.begin(), open.end());
    for(const auto& task : open)
      sorted.push_back(std::move(tasks[std::get<2>(task)]));
    std::size_t next = 0;
    for(Removal_task& task : tasks)
      if(!task.is_done())
        task = std::move(sorted[next++]);
  }

  // Those nearer than that, the nearest first.
  void give_nearest(std::vector<Removal_task>& tasks,
                    const std::vector<std::size_t>& numbers,
                    double most,
                    Assignment& done) const {
    for(Candidates nearest = candidates(tasks, numbers, most, done); !nearest.empty();) {
      const auto [d, is_measured, i, k] = nearest.top();
      nearest.pop();
      if(done.pair[i] != none || done.is_taken[k] || d >= most)
        continue;
      if(!is_measured) {
        nearest.push({distance(tasks[i], k), true, i, k});
        continue;
      }
      done.pair[i] = k;
      done.is_taken[k] = 1;
      if(tasks[i].has_failed())
        give(pairs_[k], tasks[i]);
    }
  }

  // How far a task is from a pair, or less than that if it is not measured yet, and their numbers.
  using Candidate = std::tuple<double, bool, std::size_t, std::size_t>;
  using Candidates = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

  // Those that are left and may be nearer than that, with lower bounds.
  Candidates candidates(const std::vector<Removal_task>& tasks,
                        const std::vector<std::size_t>& numbers,
                        double most,
                        const Assignment& done) const {
    std::vector<Candidate> all;
    for(std::size_t i : numbers) {
      if(done.pair[i] != none)
        continue;
      std::vector<Box<3>> boxes; // by choice
      for(const Loop_choice& choice : tasks[i].choices)
        boxes.push_back(Loop_distance::box(mesh_, choice));
      for(std::size_t k = 0; k < pairs_.size(); ++k) {
        const auto bound = [&](std::size_t choice, const Loop_distance& from) {
          return from.bound(boxes[choice]);
        };
        if(!done.is_taken[k])
          if(const double d = least(tasks[i], k, bound); d < most)
            all.push_back({d, false, i, k});
      }
    }
    return Candidates(std::greater<>(), std::move(all));
  }

  // How far a loop of a pair is from where a task has one of the same kind.
  double distance(const Removal_task& task, std::size_t pair) const {
    return least(task, pair, [&](std::size_t choice, const Loop_distance& from) {
      return from(mesh_, task.choices[choice]);
    });
  }

  // Of `f(i, d)` for the choices of a task, by their numbers, and the loops of a pair of their
  // kinds.
  template <typename Function>
  double least(const Removal_task& task, std::size_t pair, const Function& f) const {
    double least = infinite;
    for(std::size_t i = 0; i < task.choices.size(); ++i)
      least = (std::min)(least,
                         f(i, distances_[pair][task.choices[i].type == Loop_type::HANDLE ? 0 : 1]));
    return least;
  }

  // As if the task was a new one.
  void give(const Pair& pair, Removal_task& task) const {
    for(Loop_choice& choice : task.choices) {
      choice.length = pair.loop(choice.type).length;
      choice.places = pair.loop(choice.type).places;
    }
    const auto rank = [](const Loop_choice& choice) {
      return std::make_tuple(!choice.is_allowed, choice.length, choice.type != Loop_type::HANDLE);
    };
    std::sort(task.choices.begin(), task.choices.end(),
              [&](const Loop_choice& a, const Loop_choice& b) { return rank(a) < rank(b); });
    task.state = Removal_task::State::OPEN;
    task.are_given_loops = task.comes_first = false;
    task.region.reset();
  }

  const Surgery_mesh& mesh_;
  std::vector<Pair> pairs_;
  std::vector<std::array<Loop_distance, 2>> distances_; // from the loops of each
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOPS_ANEW_H
