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

#include <CGAL/Handle_tunnel_loops/internal/removal/Cut_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/caps.h>
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
Removes handles from a mesh: takes out a strip along a simple loop that does not separate the
surface, and closes the two holes by caps, which lowers the genus by one and leaves the rest of the
surface as it is, in one piece. That all this is so is decided on the mesh as it is by then: simple,
an annulus, in one piece by counting; that the caps meet nothing by exact predicates.

Handles far from each other are removed in the same round, caps being made by all threads; what is
taken is decided in the order of the tasks. A handle that cannot be removed in one way is tried in
the next one in the next round: with a narrower strip, along a loop beside, along another loop.
*/
class Handle_removal
{
public:
  /// \p least_area is that of a piece that comes off at a neck.
  Handle_removal(Execution execution, Surgery_mesh& mesh, double least_area = 0.)
      : execution_(execution)
      , mesh_(mesh)
      , least_area_(least_area) {}

  /// \p ask is called with the number of tasks that are done, and throws to stop.
  template <typename Ask> void operator()(std::vector<Removal_task>& tasks, const Ask& ask) {
    start(tasks);
    for(std::vector<Attempt> attempts; !(attempts = choose(tasks)).empty();) {
      make_caps(attempts);
      find_good_caps(attempts);
      std::vector<Placed_patch> put_in;
      for(const Attempt& attempt : attempts)
        carry_out(attempt, tasks[attempt.task], put_in);
      ask(std::count_if(tasks.begin(), tasks.end(), is_done));
    }
  }

private:
  // How a strip is laid along a loop.
  enum Style { WIDE, NARROW, TO_ONE_SIDE, TO_THE_OTHER_SIDE, END };

  // What is tried next of a task.
  struct Course
  {
    std::size_t choice = 0;
    int style = WIDE;
    std::vector<Closed_walk> walks; // by choice
    bool is_damaged = false;
  };

  struct Attempt
  {
    std::size_t task;
    Cut_strip strip;
    std::vector<Patch> ways = {}; // the first one does not meet itself
    bool are_triangulated = false;
    bool is_good = false; // the first way meets no face that stays
  };

  static bool is_done(const Removal_task& task) { return task.state != Removal_task::State::OPEN; }

  void start(std::vector<Removal_task>& tasks) {
    courses_.assign(tasks.size(), Course());
    for_each_index(
        execution_, tasks.size(),
        [&](std::size_t i) {
          if(is_done(tasks[i]))
            return;
          tasks[i].reasons.assign(tasks[i].choices.size(), std::string());
          for(const Loop_choice& choice : tasks[i].choices)
            courses_[i].walks.push_back(simple_part(Walk_beside_loop(mesh_, choice.places)()));
        },
        16);
  }

  // ---- what is tried in a round

  std::vector<Attempt> choose(std::vector<Removal_task>& tasks) {
    std::vector<Attempt> attempts;
    is_claimed_.assign(mesh_.vertex_bound(), 0);
    reserve_walks(tasks);
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(tasks[i].state == Removal_task::State::OPEN)
        if(std::optional<Cut_strip> strip = next_strip(tasks[i], courses_[i]))
          if(claim(*strip))
            attempts.push_back({i, std::move(*strip)});
    return attempts;
  }

  // Where others are to be removed along, wide strips do not go.
  void reserve_walks(const std::vector<Removal_task>& tasks) {
    number_of_walks_at_.assign(mesh_.vertex_bound(), 0);
    for(std::size_t i = 0; i < tasks.size(); ++i)
      if(tasks[i].state == Removal_task::State::OPEN)
        reserve(courses_[i].walks[courses_[i].choice], 1);
  }

  void reserve(const Closed_walk& walk, int by) {
    for(Index v : walk)
      number_of_walks_at_[v] += by;
  }

  // The next one that there is, or what becomes of the task if there is none.
  std::optional<Cut_strip> next_strip(Removal_task& task, Course& course) {
    while(course.choice < task.choices.size()) {
      std::string& reason = task.reasons[course.choice];
      const Closed_walk& walk = course.walks[course.choice];
      if(walk.size() < 3)
        reason = "the loop is not simple";
      else if(!is_intact(mesh_, walk)) {
        reason = "another handle was removed across the loop";
        course.is_damaged = true;
      } else
        for(; course.style != END; ++course.style) {
          if(std::optional<Cut_strip> strip = strip_of(walk, course.style))
            return strip;
          if(reason.empty())
            reason = "the mesh is too coarse along the loop";
        }
      ++course.choice;
      course.style = WIDE;
    }
    task.state = course.is_damaged ? Removal_task::State::DAMAGED : Removal_task::State::REFUSED;
    return std::nullopt;
  }

  std::optional<Cut_strip> strip_of(const Closed_walk& walk, int style) {
    std::optional<Cut_strip> strip = Cut_strip::around(mesh_, walk);
    if(!strip || style == NARROW)
      return strip;
    reserve(walk, -1);
    const Cut_strip wide = widened(*strip, 2 * walk.size(), style == WIDE ? 2 : 4);
    reserve(walk, 1);
    if(style == WIDE)
      return wide;
    // The loop along a border of the wide strip, and what is at it.
    const std::size_t side = style == TO_ONE_SIDE ? 0 : 1;
    Closed_walk beside;
    for(Index h : wide.border(side))
      beside.push_back(mesh_.source(h));
    return Cut_strip::around(mesh_, beside);
  }

  Cut_strip widened(Cut_strip strip, std::size_t longest_border, int rings) const {
    for(int ring = 0; ring < rings; ++ring)
      for(std::size_t side : {0, 1})
        if(std::optional<Cut_strip> wider = strip.wider(mesh_, side))
          if(wider->border(side).size() <= longest_border && !has_vertex(*wider, [this](Index v) {
               return is_claimed_[v] || number_of_walks_at_[v] > 0;
             }))
            strip = std::move(*wider);
    return strip;
  }

  template <typename Predicate>
  bool has_vertex(const Cut_strip& strip, const Predicate& predicate) const {
    return std::any_of(strip.faces().begin(), strip.faces().end(), [&](Index f) {
      const Surgery_mesh::Face& c = mesh_.corners(f);
      return std::any_of(c.begin(), c.end(), predicate);
    });
  }

  // Strips of the same round have no vertex in common.
  bool claim(const Cut_strip& strip) {
    if(has_vertex(strip, [this](Index v) { return is_claimed_[v] != 0; }))
      return false;
    for(Index f : strip.faces())
      for(Index v : mesh_.corners(f))
        is_claimed_[v] = 1;
    return true;
  }

  // ---- caps

  void make_caps(std::vector<Attempt>& attempts) const {
    for_each_index(
        execution_, attempts.size(),
        [&](std::size_t i) {
          attempts[i].ways = caps_of(mesh_, attempts[i].strip);
          attempts[i].are_triangulated = !attempts[i].ways.empty();
          drop_until_embedded(attempts[i]);
        },
        1);
  }

  void drop_until_embedded(Attempt& attempt) const {
    std::vector<Patch>& ways = attempt.ways;
    while(!ways.empty() && !Placed_patch(mesh_, ways.front()).is_embedded())
      ways.erase(ways.begin());
  }

  // Each attempt goes on with its next way as long as its caps meet a face.
  void find_good_caps(std::vector<Attempt>& attempts) const {
    for(;;) {
      std::vector<Attempt*> open;
      std::vector<Replacement> replacements;
      for(Attempt& attempt : attempts)
        if(!attempt.is_good && !attempt.ways.empty()) {
          open.push_back(&attempt);
          replacements.push_back({&attempt.strip.faces(), &attempt.ways.front()});
        }
      if(open.empty())
        return;
      const std::vector<char> meets = meet_mesh(execution_, mesh_, replacements);
      for(std::size_t i = 0; i < open.size(); ++i)
        if(!meets[i])
          open[i]->is_good = true;
        else {
          open[i]->ways.erase(open[i]->ways.begin());
          drop_until_embedded(*open[i]);
        }
    }
  }

  // ---- what is done

  void carry_out(const Attempt& attempt, Removal_task& task, std::vector<Placed_patch>& put_in) {
    Course& course = courses_[attempt.task];
    const auto fails = [&](const char* why) { task.reasons[course.choice] = why; };
    if(!attempt.is_good) {
      fails(attempt.are_triangulated ? "the caps would meet the surface"
                                     : "the holes cannot be triangulated");
      ++course.style;
      return;
    }
    const Patch& caps = attempt.ways.front();
    Placed_patch placed(mesh_, caps, mesh_.vertex_bound());
    // It is tried again in the next round, where these are faces of the mesh.
    if(std::any_of(put_in.begin(), put_in.end(),
                   [&](const Placed_patch& other) { return placed.meets(other); }))
      return;
    if(const char* why = why_not_along(attempt.strip, task)) {
      fails(why);
      course.style = END;
      return;
    }
    for(const Placed_triangle& t : placed.triangles())
      task.area += t.area();
    task.volume = volume_between(attempt.strip, placed);
    task.choice = course.choice;
    task.state = Removal_task::State::REMOVED;
    put_in_place(mesh_, attempt.strip.faces(), caps);
    put_in.push_back(std::move(placed));
  }

  const char* why_not_along(const Cut_strip& strip, const Removal_task& task) {
    const Rest rest = separation_(mesh_, strip, least_area_);
    if(task.pair != Removal_task::is_neck)
      return rest == Rest::ONE_PIECE ? nullptr : "the loop separates the surface";
    if(rest == Rest::TWO_PIECES)
      return nullptr;
    return rest == Rest::ONE_PIECE ? "the loop does not separate the surface"
                                   : "the piece that would come off is too small";
  }

  // Of what lies between a strip and its caps: positive if that is inside.
  double volume_between(const Cut_strip& strip, const Placed_patch& caps) const {
    const Surgery_mesh::Point origin = mesh_.point(mesh_.source(strip.border(0).front()));
    const auto volume = [&](const Placed_triangle& t) {
      return CGAL::volume(origin, t.points[0], t.points[1], t.points[2]);
    };
    double sum = 0.;
    for(Index f : strip.faces())
      sum += volume(placed_triangle(mesh_, f));
    for(const Placed_triangle& t : caps.triangles())
      sum -= volume(t);
    return sum;
  }

  const Execution execution_;
  Surgery_mesh& mesh_;
  const double least_area_;
  Separation separation_;
  std::vector<Course> courses_; // by task
  // By vertex, for the strips of a round.
  std::vector<char> is_claimed_;
  std::vector<int> number_of_walks_at_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVAL_H
