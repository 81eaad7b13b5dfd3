// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVAL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVAL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Region_layout.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_proposal.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/patch_contacts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Removes handles from a mesh: takes out a region and closes its holes by caps, which lowers the genus
by one and leaves the rest of the surface as it is, in one piece. That all this is so is decided on
the mesh as it is by then: what the region is and that the rest is in one piece by counting, that
the caps meet nothing by exact predicates.

Handles far from each other are removed in the same round, caps being made by all threads; what is
taken is decided in the order of the tasks. A handle that cannot be removed in one way is tried in
the next one in the next round.
*/
class Handle_removal
{
public:
  Handle_removal(Execution execution, Surgery_mesh& mesh)
      : execution_(execution)
      , mesh_(mesh)
      , meet_mesh_(mesh) {
    measure_mesh();
  }

  /// \p ask is called with the number of tasks that are done, and throws to stop.
  template <typename Ask> void operator()(std::vector<Removal_task>& tasks, const Ask& ask) {
    start(tasks);
    for(std::vector<Attempt> attempts; !(attempts = choose(tasks)).empty();) {
      make_caps(attempts);
      find_good_caps(attempts);
      is_one_piece_without_all_ = is_one_piece_without(attempts, tasks);
      put_in_.clear();
      for(const Attempt& attempt : attempts)
        carry_out(attempt, tasks);
      ask(std::count_if(tasks.begin(), tasks.end(), is_done));
    }
  }

private:
  // What is tried next of a task.
  struct Course
  {
    std::vector<Closed_walk> walks; // by choice
    std::vector<Way_of_removal> ways;
    std::size_t next = 0;
    bool is_damaged = false;
  };

  struct Attempt
  {
    std::size_t task;
    Removal_proposal proposal;
    std::vector<std::size_t> companions; // tasks that are done with it
    std::vector<Patch> patches = {};     // the first one does not meet itself
    bool are_triangulated = false;
    bool is_good = false; // the first patch meets no face that stays
  };

  static bool is_done(const Removal_task& task) { return task.state != Removal_task::State::OPEN; }

  void start(std::vector<Removal_task>& tasks) {
    courses_.assign(tasks.size(), Course());
    for_each_index(
        execution_, tasks.size(),
        [&](std::size_t i) {
          if(is_done(tasks[i]))
            return;
          Course& course = courses_[i];
          tasks[i].reasons.assign(tasks[i].choices.size(), std::string());
          course.ways = ways_of_removal(tasks[i].choices.size());
          for(const Loop_choice& choice : tasks[i].choices)
            course.walks.push_back(simple_part(walk_beside(mesh_, choice.places)));
        },
        16);
  }

  // ---- what is tried in a round

  std::vector<Attempt> choose(std::vector<Removal_task>& tasks) {
    std::vector<Attempt> attempts;
    Region_layout layout(mesh_);
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(!is_done(tasks[i]))
        layout.reserve(walk_of_next(courses_[i]), 1);
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(!is_done(tasks[i])) {
        layout.reserve(walk_of_next(courses_[i]), -1);
        if(std::optional<Attempt> attempt = next_attempt(tasks, i, layout))
          if(layout.claim(attempt->proposal))
            attempts.push_back(std::move(*attempt));
      }
    return attempts;
  }

  static const Closed_walk& walk_of_next(const Course& course) {
    return course.walks[course.ways[course.next].choice];
  }

  // The next one that there is, or what becomes of the task if there is none.
  std::optional<Attempt>
  next_attempt(std::vector<Removal_task>& tasks, std::size_t i, const Region_layout& layout) {
    Course& course = courses_[i];
    for(; course.next < course.ways.size(); ++course.next) {
      const Way_of_removal& way = course.ways[course.next];
      std::string& reason = tasks[i].reasons[way.choice];
      if(const char* why = why_not_at_all(course, way))
        reason = why;
      else if(std::optional<Removal_proposal> proposal = layout.proposal(way, course.walks)) {
        Attempt attempt{i, std::move(*proposal), {}};
        if(find_companions(tasks, attempt))
          return attempt;
      } else if(reason.empty())
        reason = "the mesh is too coarse along the loop";
    }
    give_up_at_end(tasks[i], course);
    return std::nullopt;
  }

  // Whether a region holds no other handles than those of tasks.
  bool find_companions(const std::vector<Removal_task>& tasks, Attempt& attempt) const {
    const std::size_t number = attempt.proposal.region().number_of_handles() - 1;
    if(number == 0)
      return true;
    const std::vector<Index> inside = attempt.proposal.vertices(mesh_);
    const auto is_inside = [&](const Closed_walk& walk) {
      return walk.size() >= 3 && std::all_of(walk.begin(), walk.end(), [&](Index v) {
               return std::binary_search(inside.begin(), inside.end(), v);
             });
    };
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(i != attempt.task && !is_done(tasks[i]) &&
         std::all_of(courses_[i].walks.begin(), courses_[i].walks.end(), is_inside))
        attempt.companions.push_back(i);
    return attempt.companions.size() == number;
  }

  static void give_up_at_end(Removal_task& task, const Course& course) {
    if(course.next == course.ways.size())
      task.state = course.is_damaged ? Removal_task::State::DAMAGED : Removal_task::State::REFUSED;
  }

  // A way that takes one loop, or both.
  const char* why_not_at_all(Course& course, const Way_of_removal& way) const {
    for(std::size_t i = 0; i < course.walks.size(); ++i) {
      if(i != way.choice && !way.takes_both_loops())
        continue;
      if(course.walks[i].size() < 3)
        return "the loop is not simple";
      if(!is_intact(mesh_, course.walks[i])) {
        course.is_damaged = true;
        return "another handle was removed across the loop";
      }
    }
    return nullptr;
  }

  // ---- caps

  void make_caps(std::vector<Attempt>& attempts) const {
    for_each_index(
        execution_, attempts.size(),
        [&](std::size_t i) {
          attempts[i].patches = attempts[i].proposal.patches();
          attempts[i].are_triangulated = !attempts[i].patches.empty();
          drop_until_embedded(attempts[i].patches);
        },
        1);
  }

  void drop_until_embedded(std::vector<Patch>& patches) const {
    while(!patches.empty() && !Placed_patch(mesh_, patches.front()).is_embedded())
      patches.erase(patches.begin());
  }

  // Each attempt goes on with its next patch as long as that meets a face.
  void find_good_caps(std::vector<Attempt>& attempts) {
    for(;;) {
      std::vector<Attempt*> open;
      std::vector<Replacement> replacements;
      for(Attempt& attempt : attempts)
        if(!attempt.is_good && !attempt.patches.empty()) {
          open.push_back(&attempt);
          replacements.push_back({&attempt.proposal.out(), &attempt.patches.front()});
        }
      if(open.empty())
        return;
      const std::vector<char> meets = meet_mesh_(execution_, replacements);
      for_each_index(
          execution_, open.size(),
          [&](std::size_t i) {
            open[i]->is_good = !meets[i];
            if(meets[i]) {
              open[i]->patches.erase(open[i]->patches.begin());
              drop_until_embedded(open[i]->patches);
            }
          },
          1);
    }
  }

  // ---- what is done

  void carry_out(const Attempt& attempt, std::vector<Removal_task>& tasks) {
    Removal_task& task = tasks[attempt.task];
    Course& course = courses_[attempt.task];
    const Way_of_removal& way = course.ways[course.next];
    const auto fails = [&](const char* why) {
      task.reasons[way.choice] = why;
      ++course.next;
      give_up_at_end(task, course);
    };
    if(!attempt.is_good)
      return fails(attempt.are_triangulated ? "the caps would meet the surface"
                                            : "the holes cannot be triangulated");
    const Patch& patch = attempt.patches.front();
    Placed_patch placed(mesh_, patch, mesh_.vertex_bound());
    if(must_wait(attempt.proposal, placed))
      return;
    if(const char* why = why_not(attempt.proposal, task))
      return fails(why);
    const double number = static_cast<double>(1 + attempt.companions.size());
    task.choice = way.choice;
    task.is_whole = attempt.proposal.region().number_of_borders() == 1;
    task.area = area_of_caps(placed) / number;
    task.volume = volume_between(attempt.proposal.out(), placed) / number;
    task.state = Removal_task::State::REMOVED;
    for(std::size_t i : attempt.companions)
      tasks[i].become_like(task);
    put_in_place(mesh_, attempt.proposal.out(), patch);
    put_in_.push_back(std::move(placed));
  }

  // For the next round, when what was put in in this one is part of the mesh.
  bool must_wait(const Removal_proposal& proposal, const Placed_patch& placed) const {
    if(proposal.is_subdivided() && !put_in_.empty())
      return true; // of a copy of the mesh
    return std::any_of(put_in_.begin(), put_in_.end(),
                       [&](const Placed_patch& other) { return placed.meets(other); });
  }

  // If the surface stays in one piece without all regions of a round, it does so without each of
  // them, whatever becomes of the others. That is found faster for many of them at once.
  bool is_one_piece_without(const std::vector<Attempt>& attempts,
                            const std::vector<Removal_task>& tasks) {
    constexpr std::size_t many = 16;
    if(attempts.size() < many || tasks[attempts.front().task].pair == Removal_task::is_neck)
      return false;
    if(number_of_pieces_ == 0)
      number_of_pieces_ = number_of_pieces(execution_, mesh_, {});
    std::vector<Index> out;
    for(const Attempt& attempt : attempts) {
      if(attempt.proposal.is_subdivided())
        return false; // more than the region goes out
      out.insert(out.end(), attempt.proposal.out().begin(), attempt.proposal.out().end());
    }
    return number_of_pieces(execution_, mesh_, out) == number_of_pieces_;
  }

  const char* why_not(const Removal_proposal& proposal, const Removal_task& task) {
    if(is_one_piece_without_all_)
      return nullptr;
    const bool separates = separates_(proposal.mesh_of_region(), proposal.region());
    if(separates == (task.pair == Removal_task::is_neck))
      return nullptr;
    return separates ? "the loop separates the surface" : "the loop does not separate the surface";
  }

  static double area_of_caps(const Placed_patch& patch) {
    double sum = 0.;
    for(std::size_t i = patch.number_of_parts(); i < patch.triangles().size(); ++i)
      sum += patch.triangles()[i].area();
    return sum;
  }

  double volume(const Placed_triangle& t) const {
    return CGAL::volume(origin_, t.points[0], t.points[1], t.points[2]);
  }

  // Of what lies between faces and those that take their place: positive if that is inside.
  double volume_between(const std::vector<Index>& out, const Placed_patch& patch) const {
    double sum = 0.;
    for(Index f : out)
      sum += volume(placed_triangle(mesh_, f));
    for(const Placed_triangle& t : patch.triangles())
      sum -= volume(t);
    return outward_ * sum;
  }

  // Faces may point inwards.
  void measure_mesh() {
    Index first = 0;
    while(first < mesh_.face_bound() && !mesh_.is_alive(first))
      ++first;
    if(first == mesh_.face_bound())
      return;
    origin_ = mesh_.point(mesh_.corners(first)[0]);
    double sum = 0.;
    for(Index f = first; f < mesh_.face_bound(); ++f)
      if(mesh_.is_alive(f))
        sum += volume(placed_triangle(mesh_, f));
    outward_ = sum < 0. ? -1. : 1.;
  }

  const Execution execution_;
  Surgery_mesh& mesh_;
  Mesh_contacts meet_mesh_;
  Separation separates_;
  std::size_t number_of_pieces_ = 0; // of the surface; handles do not change it
  bool is_one_piece_without_all_ = false;
  Surgery_mesh::Point origin_;       // a vertex
  double outward_ = 1.;              // or -1
  std::vector<Course> courses_;      // by task
  std::vector<Placed_patch> put_in_; // in this round
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVAL_H
