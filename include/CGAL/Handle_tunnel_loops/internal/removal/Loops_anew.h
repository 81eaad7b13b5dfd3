// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_ANEW_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_ANEW_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Mesh_link.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A mesh under surgery as a `Surface_mesh`, for what finds loops on such a one.
class Surface_copy
{
public:
  using Mesh = Surface_mesh<Surgery_mesh::Point>;

  explicit Surface_copy(const Surgery_mesh& original) {
    Mesh_link<Mesh, std::decay_t<decltype(mesh_.points())>> link(mesh_, mesh_.points());
    link.write_back(
        original, [this](Index number, Mesh::Vertex_index) { numbers_.push_back(number); },
        [](Index, Mesh::Face_index) {});
  }

  const Mesh& mesh() const { return mesh_; }

  /// where a loop on the copy lies on the original.
  template <typename Loop> std::vector<Place_on_edge> places(const Loop& loop) const {
    std::vector<Place_on_edge> places;
    for(const auto& step : loop.steps())
      places.push_back({numbers_[source(step.halfedge, mesh_)],
                        numbers_[target(step.halfedge, mesh_)], step.ratio});
    return places;
  }

private:
  Mesh mesh_;
  std::vector<Index> numbers_; // by vertex
};

/// Finds the loops of a surface from which some handles were removed, and which of them are those
/// of handles that are still there: they lie where these had theirs.
class Loops_anew
{
  using Mesh = Surface_copy::Mesh;
  using Pair = Handle_tunnel_pair<Mesh>;

public:
  Loops_anew(Execution execution, const Surgery_mesh& mesh)
      : mesh_(mesh)
      , copy_(mesh) {
    find(execution);
  }

  /// gives new loops to those that are damaged. Those that are not found stay as they are.
  void give_to(std::vector<Removal_task>& tasks) const {
    std::vector<std::size_t> old;
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(tasks[i].state != Removal_task::State::REMOVED && !tasks[i].is_of_neck())
        old.push_back(i);
    // If all handles are known, the last ones have nothing else left.
    const bool are_all_known = old.size() == pairs_.size();
    std::vector<std::tuple<double, std::size_t, std::size_t>> distances;
    for(std::size_t i : old)
      for(std::size_t k = 0; k < pairs_.size(); ++k) {
        const double d = distance(tasks[i], pairs_[k]);
        if(are_all_known || d < 1.)
          distances.push_back({d, i, k});
      }
    std::sort(distances.begin(), distances.end());
    std::vector<char> is_named(tasks.size(), 0), is_taken(pairs_.size(), 0);
    for(const auto& [d, i, k] : distances)
      if(!is_named[i] && !is_taken[k]) {
        is_named[i] = is_taken[k] = 1;
        if(tasks[i].state == Removal_task::State::DAMAGED)
          give(pairs_[k], tasks[i]);
      }
  }

private:
  void find(Execution execution) {
    Handle_tunnel_loops_solver<Mesh> solver(copy_.mesh());
    if(execution.is_parallel())
      solver.find_loops<Parallel_if_available_tag>(std::back_inserter(pairs_));
    else
      solver.find_loops(std::back_inserter(pairs_));
  }

  // How far a loop of a pair is from where a task has one of the same kind.
  double distance(const Removal_task& task, const Pair& pair) const {
    double least = (std::numeric_limits<double>::infinity)();
    for(const Loop_choice& choice : task.choices) {
      const Pair::Loop& loop = pair.loop(choice.type);
      least = (std::min)(least, loop_distance(mesh_, loop.points(), loop.length(), choice));
    }
    return least;
  }

  void give(const Pair& pair, Removal_task& task) const {
    for(Loop_choice& choice : task.choices) {
      const Pair::Loop& loop = pair.loop(choice.type);
      choice.length = loop.length();
      choice.places = copy_.places(loop);
    }
    std::stable_sort(
        task.choices.begin(), task.choices.end(), [](const Loop_choice& a, const Loop_choice& b) {
          return std::make_pair(!a.is_allowed, a.length) < std::make_pair(!b.is_allowed, b.length);
        });
    task.state = Removal_task::State::OPEN;
  }

  const Surgery_mesh& mesh_;
  Surface_copy copy_;
  std::vector<Pair> pairs_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_LOOPS_ANEW_H
