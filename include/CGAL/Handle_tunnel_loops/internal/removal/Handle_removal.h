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

#include <CGAL/Handle_tunnel_loops/internal/patches/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/patches/patch_contacts.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Enclosed_volume.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Loops_at_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Region_layout.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_course.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_proposal.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Detour.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/separating_strips.h>

#include <algorithm>
#include <cstddef>
#include <optional>
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

Handles far from each other are removed in the same round, regions and caps being made by all
threads; what is taken is decided in the order of the tasks. A handle that cannot be removed in one
way is tried in the next one in the next round. Loops of other handles are led around what was
removed.
*/
class Handle_removal
{
public:
  Handle_removal(Execution execution, Surgery_mesh& mesh)
      : execution_(execution)
      , mesh_(mesh)
      , meet_mesh_(mesh)
      , volume_(mesh) {}

  /// \p ask is called with the number of tasks that are done, and throws to stop.
  template <typename Ask> void operator()(std::vector<Removal_task>& tasks, const Ask& ask) {
    start(tasks);
    const auto ask_now = [&] {
      ask(std::count_if(tasks.begin(), tasks.end(),
                        [](const auto& task) { return task.is_done(); }));
    };
    for(std::vector<Attempt> attempts; !(attempts = choose()).empty(); ask_now()) {
      ask_now();
      make_caps(attempts);
      ask_now();
      find_good_caps(attempts);
      find_harmless_strips(attempts);
      put_in_.clear();
      for(const Attempt& attempt : attempts)
        carry_out(attempt);
    }
  }

private:
  using Loop = Loops_at_vertices::Loop;

  struct Attempt
  {
    Removal_course* course;
    std::vector<Index> vertices;                // of what is taken out
    std::vector<Removal_task*> companions = {}; // tasks that are done with it
    std::vector<Patch> patches = {};            // the first one does not meet itself
    bool are_triangulated = false;
    bool is_any_embedded = false; // of the patches
    bool is_good = false;         // the first patch meets no face that stays
    bool is_harmless = false;     // to the pieces of the surface, with all others that are so

    bool is_of_neck() const { return course->task().pair == Removal_task::is_neck; }
    bool is_strip() const { return proposal().region().number_of_borders() == 2; }
    const Removal_proposal& proposal() const { return *course->proposal(); }
  };

  void start(std::vector<Removal_task>& tasks) {
    std::vector<Removal_task*> open;
    for(Removal_task& task : tasks)
      if(!task.is_done())
        open.push_back(&task);
    std::vector<std::optional<Removal_course>> courses(open.size());
    for_each_index(
        execution_, open.size(), [&](std::size_t i) { courses[i].emplace(mesh_, *open[i]); }, 16);
    courses_.clear();
    for(std::optional<Removal_course>& course : courses)
      courses_.push_back(std::move(*course));
    loops_ = Loops_at_vertices();
    for(std::size_t i = 0; i < courses_.size(); ++i)
      for(std::size_t k = 0; k < courses_[i].walks().size(); ++k)
        loops_.add({i, k}, courses_[i].walks()[k]);
  }

  // ---- what is tried in a round

  std::vector<Attempt> choose() {
    Region_layout layout(mesh_);
    for(Removal_course& course : courses_)
      if(!course.is_done())
        course.reserve(layout);
    for_each_index(
        execution_, courses_.size(),
        [&](std::size_t i) {
          if(!courses_[i].is_done())
            courses_[i].propose(mesh_, layout);
        },
        1);
    std::vector<Attempt> attempts;
    for(Removal_course& course : courses_)
      if(std::optional<Attempt> attempt = next_attempt(course, layout)) {
        layout.claim(attempt->vertices);
        attempts.push_back(std::move(*attempt));
      }
    return attempts;
  }

  // Nothing if there is no way left, or if it has to wait for the next round.
  std::optional<Attempt> next_attempt(Removal_course& course, const Region_layout& layout) {
    while(!course.is_done()) {
      if(!layout.is_free(*course.proposal()) && course.way().fits_into_room())
        course.propose_again(layout);
      if(!course.proposal() || !layout.is_free(*course.proposal()))
        break;
      Attempt attempt{&course, vertices_of(mesh_, course.proposal()->out())};
      if(find_companions(attempt))
        return attempt;
      course.fail("there are other handles around");
      course.propose(mesh_, layout);
    }
    return std::nullopt;
  }

  // Whether a region holds no other handles than those of tasks.
  bool find_companions(Attempt& attempt) {
    const std::size_t number = attempt.proposal().region().number_of_handles() - 1;
    if(number == 0)
      return true;
    const auto is_inside = [&](const Closed_walk& walk) {
      return walk.size() >= 3 && std::all_of(walk.begin(), walk.end(),
                                             [&](Index v) { return is_in(v, attempt.vertices); });
    };
    for(Removal_course& course : courses_)
      if(&course != attempt.course && !course.is_done() &&
         std::all_of(course.walks().begin(), course.walks().end(), is_inside))
        attempt.companions.push_back(&course.task());
    return attempt.companions.size() == number;
  }

  // ---- caps

  void make_caps(std::vector<Attempt>& attempts) const {
    for_each_index(
        execution_, attempts.size(),
        [&](std::size_t i) {
          attempts[i].patches = attempts[i].proposal().patches(mesh_);
          attempts[i].are_triangulated = !attempts[i].patches.empty();
          drop_until_embedded(attempts[i].patches);
          attempts[i].is_any_embedded = !attempts[i].patches.empty();
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
          replacements.push_back({&attempt.proposal().out(), &attempt.patches.front()});
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

  // Where they are few, each is looked at when its turn comes.
  void find_harmless_strips(std::vector<Attempt>& attempts) {
    constexpr std::size_t few = 4;
    std::vector<Attempt*> open;
    std::vector<const Cut_region*> strips;
    for(Attempt& attempt : attempts)
      if(attempt.is_good && attempt.is_strip() && !attempt.is_of_neck() &&
         !attempt.proposal().is_subdivided())
      {
        open.push_back(&attempt);
        strips.push_back(&attempt.proposal().region());
      }
    if(open.size() < few)
      return;
    const std::vector<char> separates = separating_strips(execution_, mesh_, strips);
    for(std::size_t i = 0; i < open.size(); ++i)
      open[i]->is_harmless = !separates[i];
    are_others_whole_ = true;
  }

  // ---- what is done

  void carry_out(const Attempt& attempt) {
    if(attempt.course->is_done())
      return; // with another one
    if(!attempt.are_triangulated)
      return attempt.course->fail("the holes cannot be triangulated");
    if(!attempt.is_any_embedded)
      return attempt.course->fail_at_loop();
    if(!attempt.is_good)
      return attempt.course->fail("the caps would meet the surface");
    const Patch& patch = attempt.patches.front();
    Placed_patch placed(mesh_, patch, mesh_.vertex_bound());
    // What was put in in this round is part of the mesh in the next one only.
    if(std::any_of(put_in_.begin(), put_in_.end(),
                   [&](const Placed_patch& other) { return placed.meets(other); }))
      return;
    if(const bool separates = attempt.is_strip() && this->separates(attempt);
       separates != attempt.is_of_neck())
      return separates ? attempt.course->fail_along_loop()
                       : attempt.course->fail("the loop does not separate the surface");
    describe(attempt, placed);
    Removal_task& task = attempt.course->task();
    const Index first_face = put_in_place(mesh_, attempt.proposal().out(), patch);
    task.end_of_faces = mesh_.face_bound();
    for(Removal_task* companion : attempt.companions)
      companion->become_like(task);
    put_in_.push_back(std::move(placed));
    // The parts of faces around the discs come first.
    const Index first_of_discs = first_face + static_cast<Index>(patch.parents.size());
    lead_around(Detour(mesh_, first_of_discs, attempt.course->partner()),
                loops_.at(attempt.vertices));
  }

  void lead_around(const Detour& detour, const std::vector<Loop>& near) {
    for(const Loop& loop : near) {
      Removal_course& course = courses_[loop.first];
      if(!course.is_done() && course.lead_around(mesh_, detour, loop.second))
        loops_.add(loop, course.walks()[loop.second]);
    }
  }

  bool separates(const Attempt& attempt) {
    if(attempt.is_harmless && are_others_whole_)
      return false;
    const bool separates = separates_(mesh_, attempt.proposal().sides(mesh_));
    if(!separates)
      are_others_whole_ = false; // it is taken out too
    return separates;
  }

  void describe(const Attempt& attempt, const Placed_patch& patch) const {
    Removal_task& task = attempt.course->task();
    double area = 0., volume = 0.;
    for(std::size_t i = patch.number_of_parts(); i < patch.triangles().size(); ++i)
      area += patch.triangles()[i].area();
    for(Index f : attempt.proposal().out())
      volume += volume_.below(mesh_, f);
    for(const Placed_triangle& t : patch.triangles())
      volume -= volume_.below(t.points[0], t.points[1], t.points[2]);
    const double number = static_cast<double>(1 + attempt.companions.size());
    task.choice = attempt.course->way().choice;
    task.is_whole = attempt.proposal().region().number_of_borders() == 1;
    task.area = area / number;
    task.volume = volume / number;
    if(!task.are_types_known)
      task.choices[task.choice].type = volume < 0. ? Loop_type::TUNNEL : Loop_type::HANDLE;
    task.state = Removal_task::State::REMOVED;
  }

  const Execution execution_;
  Surgery_mesh& mesh_;
  Mesh_contacts meet_mesh_;
  const Enclosed_volume volume_;
  Separation separates_;
  std::vector<Removal_course> courses_; // of the tasks that were open
  Loops_at_vertices loops_;             // of these
  // In this round.
  std::vector<Placed_patch> put_in_;
  bool are_others_whole_ = false; // no strip was taken out that is not one of the harmless ones
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVAL_H
