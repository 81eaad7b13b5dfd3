// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_rounds.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/find_necks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Detour.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Handle_surgery.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loops_anew.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Parted_walls.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_candidate.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Ways_tried.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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
class Removal_rounds
{
public:
  enum class Mode {
    TOGETHER,  ///< one after the other, on what the others have left
    EACH_ALONE ///< each on the surface as it is, which stays
  };

  /// \p force removes handles even where that is no repair.
  Removal_rounds(Execution execution, Surgery_mesh& mesh, bool force, Mode mode = Mode::TOGETHER)
      : execution_(execution)
      , mesh_(mesh)
      , meet_mesh_(mesh)
      , judge_(mesh, force)
      , pieces_(execution, mesh, judge_.outward())
      , mode_(mode) {}

  /// \p ask is called again and again, and throws to stop.
  void operator()(std::vector<Removal_task>& tasks, const std::function<void()>& ask) {
    start(tasks);
    for(;; ask()) {
      const Candidates chosen = choose();
      if(chosen.empty() && is_any_first_)
        continue; // the turn of the others has come
      if(chosen.empty())
        return;
      ask();
      meet_mesh_.update(execution_);
      find_caps(chosen);
      ask();
      find_harmless_cuts(chosen);
      put_in_.clear();
      for(Removal_candidate* candidate : chosen)
        carry_out(*candidate);
    }
  }

  /// what holds all that was replaced.
  const std::vector<Box<3>>& changes() const { return changes_; }

private:
  using Candidates = std::vector<Removal_candidate*>;

  /// the number of a candidate, and which loop of it.
  using Loop = std::pair<std::size_t, std::size_t>;

  void start(std::vector<Removal_task>& tasks) {
    candidates_.clear();
    are_all_wanted_ = number_with(Removal_task::State::KEPT, tasks) == 0;
    for(Removal_task& task : tasks)
      if(task.is_left()) // those that have failed may be removed with others
        candidates_.emplace_back(task, ways_);
    for_each_index(
        execution_, candidates_.size(), [&](std::size_t i) { candidates_[i].find_loops(mesh_); },
        16);
    loops_at_.clear();
    for(std::size_t i = 0; i < candidates_.size(); ++i)
      for(std::size_t k = 0; k < candidates_[i].walks().size(); ++k)
        note({i, k});
  }

  // Where a loop leads.
  void note(const Loop& loop) {
    for(Index v : candidates_[loop.first].walks()[loop.second]) {
      const auto [begin, end] = loops_at_.equal_range(v);
      if(std::none_of(begin, end, [&](const auto& at) { return at.second == loop; }))
        loops_at_.insert({v, loop});
    }
  }

  // ---- what is tried in a round

  Candidates choose() {
    Region_layout layout(mesh_, pieces_);
    if(mode_ == Mode::TOGETHER)
      ways_.give_up_what_is_in_vain();
    is_any_first_ = std::any_of(candidates_.begin(), candidates_.end(),
                                [](const auto& c) { return !c.is_done() && c.task().comes_first; });
    for(Removal_candidate& candidate : candidates_)
      if(!candidate.is_done() && mode_ == Mode::TOGETHER)
        candidate.reserve(layout);
    for_each_index(
        execution_, candidates_.size(),
        [&](std::size_t i) {
          if(may_be_tried(candidates_[i]))
            candidates_[i].propose(mesh_, layout);
        },
        1);
    Candidates chosen;
    for(Removal_candidate& candidate : candidates_)
      if(may_be_tried(candidate) && is_ready(candidate, layout)) {
        if(mode_ == Mode::TOGETHER)
          candidate.claim(layout);
        chosen.push_back(&candidate);
      }
    return chosen;
  }

  bool may_be_tried(const Removal_candidate& candidate) const {
    return !candidate.is_done() && (!is_any_first_ || candidate.task().comes_first);
  }

  // Not if there is nothing left to be tried, or if it has to wait for the next round.
  bool is_ready(Removal_candidate& candidate, const Region_layout& layout) {
    while(!candidate.is_done()) {
      if(!candidate.is_free(layout) && candidate.choice().style == Region_choice::RINGS)
        candidate.propose_again(mesh_, layout);
      if(!candidate.surgery() || !candidate.is_free(layout))
        return false;
      if(find_companions(candidate))
        return true;
      candidate.fail({Obstacle::NO_REGION, "other handles are too close"});
      candidate.propose(mesh_, layout);
    }
    return false;
  }

  // Whether a region holds no other handles than those of candidates, also of such that could not
  // be removed so far. If all are, those of which most lies in it are as good as the ones that it
  // holds: their loops leave it and come back.
  bool find_companions(Removal_candidate& candidate) {
    Handle_surgery& surgery = *candidate.surgery();
    surgery.companions.clear();
    const std::size_t number = surgery.number_of_handles() - 1;
    if(number == 0 || mode_ == Mode::EACH_ALONE)
      return number == 0;
    std::vector<std::pair<double, std::size_t>> others; // which are not inside, by what is not
    for(std::size_t i = 0; i < candidates_.size(); ++i) {
      Removal_candidate& other = candidates_[i];
      if(&other == &candidate || !other.task().is_left())
        continue;
      if(is_inside(other, surgery))
        surgery.companions.push_back(&other.task());
      else if(const double share = other.share_in(surgery.vertices()); share > 0.)
        others.push_back({1. - share, i});
    }
    surgery.number_inside = surgery.companions.size();
    std::sort(others.begin(), others.end());
    for(const auto& other : others)
      if(surgery.takes_all() && are_all_wanted_ && surgery.companions.size() < number)
        surgery.companions.push_back(&candidates_[other.second].task());
    return surgery.companions.size() == number;
  }

  // With both loops; of a wall, it is that around the bore, which may be closed.
  static bool is_inside(const Removal_candidate& other, const Handle_surgery& surgery) {
    for(std::size_t i = 0; i < other.walks().size(); ++i) {
      const Loop_choice& loop = other.task().choices[i];
      if(!surgery.takes_all() && (loop.type != Loop_type::TUNNEL || !loop.is_allowed))
        continue;
      const Closed_walk& walk = other.walks()[i];
      const bool is_inside =
          walk.size() >= 3 && std::all_of(walk.begin(), walk.end(),
                                          [&](Index v) { return is_in(v, surgery.vertices()); });
      if(is_inside != surgery.takes_all())
        return is_inside;
    }
    return surgery.takes_all();
  }

  void find_caps(const Candidates& chosen) {
    std::vector<Removal_candidate::Trial> trials;
    for(Removal_candidate* candidate : chosen)
      for(const Removal_candidate::Trial& trial : candidate->trials())
        trials.push_back(trial);
    for_each_index(
        execution_, trials.size(),
        [&](std::size_t i) {
          trials[i].surgery->find_caps(mesh_, meet_mesh_, judge_, trials[i].intended,
                                       trials[i].known);
        },
        1);
    for(Removal_candidate* candidate : chosen)
      candidate->take_better_one();
  }

  // Where they are few, each is looked at when its turn comes.
  void find_harmless_cuts(const Candidates& chosen) {
    constexpr std::size_t few = 4;
    std::vector<Handle_surgery*> open;
    for(Removal_candidate* candidate : chosen)
      if(Handle_surgery& surgery = *candidate->surgery();
         surgery.has_caps() && !surgery.takes_all() && surgery.number_of_handles() == 1 &&
         !candidate->task().is_of_neck())
        open.push_back(&surgery);
    if(open.size() < few)
      return;
    std::vector<Surface_cut> cuts;
    for(const Handle_surgery* surgery : open)
      cuts.push_back(surgery->cut(mesh_));
    const std::vector<char> separates = separating_cuts(execution_, mesh_, cuts);
    for(std::size_t i = 0; i < open.size(); ++i)
      open[i]->is_harmless = !separates[i];
    are_others_whole_ = true;
  }

  // ---- what is done

  void carry_out(Removal_candidate& candidate) {
    if(candidate.is_done())
      return; // with another one
    const Handle_surgery& surgery = *candidate.surgery();
    if(!surgery.has_caps())
      return candidate.fail(surgery.obstacle());
    if(!std::all_of(surgery.companions.begin(), surgery.companions.end(),
                    [](const Removal_task* companion) { return companion->is_left(); }))
      return; // others are in the region now
    Placed_patch placed(mesh_, surgery.patch(), mesh_.vertex_bound());
    // What was put in in this round is part of the mesh in the next one only.
    if(std::any_of(put_in_.begin(), put_in_.end(),
                   [&](const Placed_patch& other) { return placed.meets(other); }))
      return;
    const bool separates = !surgery.takes_all() && this->separates(surgery);
    if(separates && !candidate.task().is_of_neck())
      return candidate.fail_along_loop();
    if(!separates && candidate.task().is_of_neck())
      return candidate.fail({Obstacle::TOPOLOGY, "the loop does not separate the surface"});
    if(mode_ == Mode::EACH_ALONE)
      return describe(candidate);
    changes_.push_back(surgery.reach());
    put_in(candidate);
    put_in_.push_back(std::move(placed));
  }

  bool separates(const Handle_surgery& surgery) {
    if(surgery.is_harmless && are_others_whole_)
      return false;
    const bool separates = separates_(mesh_, surgery.cut(mesh_));
    if(!separates && mode_ == Mode::TOGETHER)
      are_others_whole_ = false; // it is taken out too
    return separates;
  }

  void put_in(Removal_candidate& candidate) {
    const Handle_surgery& surgery = *candidate.surgery();
    Removal_task& task = candidate.task();
    describe(candidate);
    const Index first_vertex = mesh_.vertex_bound();
    const Index first_face = put_in_place(mesh_, surgery.out(), surgery.patch());
    task.end_of_faces = mesh_.face_bound();
    for(Removal_task* companion : surgery.companions)
      companion->become_like(task);
    // The parts of faces around the discs come first.
    const Index first_of_discs = first_face + static_cast<Index>(surgery.patch().parents.size());
    lead_around(Detour(mesh_, first_of_discs, first_vertex, candidate.partner()),
                surgery.vertices());
    candidate.surgery().reset();
  }

  void describe(Removal_candidate& candidate) {
    Removal_task& task = candidate.task();
    const Handle_surgery& surgery = *candidate.surgery();
    const double number = static_cast<double>(1 + surgery.companions.size());
    task.choice = candidate.loop();
    task.length = candidate.length();
    task.region = candidate.choice();
    task.is_whole = surgery.takes_all();
    task.change = surgery.change();
    task.change.volume_removed /= number;
    task.change.volume_added /= number;
    task.change.cap_area /= number;
    if(!task.are_types_known)
      task.choices[task.choice].type =
          task.change.volume_added > 0. ? Loop_type::TUNNEL : Loop_type::HANDLE;
    task.state = Removal_task::State::REMOVED;
    ways_.note_success(candidate.choice());
  }

  // Those that come to a vertex of what was taken out, or came to it before they were led
  // elsewhere.
  void lead_around(const Detour& detour, const std::vector<Index>& vertices) {
    std::vector<Loop> beside;
    for(Index v : vertices)
      for(auto [it, end] = loops_at_.equal_range(v); it != end; ++it)
        beside.push_back(it->second);
    make_set(beside);
    for(const Loop& loop : beside) {
      Removal_candidate& candidate = candidates_[loop.first];
      if(candidate.task().is_left() && candidate.lead_around(mesh_, detour, loop.second))
        note(loop);
    }
  }

  const Execution execution_;
  Surgery_mesh& mesh_;
  Mesh_contacts meet_mesh_;
  Shape_judge judge_;
  const Concave_pieces pieces_;
  const Mode mode_;
  Ways_tried ways_;
  Separation separates_;
  std::vector<Removal_candidate> candidates_;     // the tasks that were open
  std::unordered_multimap<Index, Loop> loops_at_; // by vertex, also those that were led elsewhere
  bool are_all_wanted_ = false;                   // no handle is to be kept
  std::vector<Box<3>> changes_;                   // of all rounds
  // In this round.
  std::vector<Placed_patch> put_in_;
  bool is_any_first_ = false;     // others wait for that
  bool are_others_whole_ = false; // nothing was cut that is not one of the harmless ones
};

/// removes handles along other loops nearby, as long as there are any that were not tried.
static void remove_along_loops_nearby(Execution execution,
                                      Removal_rounds& remove,
                                      const Surgery_mesh& mesh,
                                      std::vector<Removal_task>& tasks,
                                      const Nearby_search& wanted,
                                      const std::function<void()>& ask) {
  Loops_nearby find_nearby(mesh, wanted);
  for(;;) {
    std::vector<Removal_task> nearby = find_nearby(execution, tasks);
    if(number_with(Removal_task::State::OPEN, nearby) == 0)
      break;
    remove(nearby, ask);
    for(std::size_t k = 0; k < tasks.size(); ++k)
      if(nearby[k].is_done() && nearby[k].state != Removal_task::State::KEPT) {
        tasks[k].note_tries(nearby[k]);
        if(nearby[k].state == Removal_task::State::REMOVED) {
          nearby[k].reach = tasks[k].reach;
          tasks[k] = std::move(nearby[k]);
        }
      }
  }
}

/// says of those that are left that they are refused, and which of them had something change within
/// their reach.
static void give_up(const std::vector<Box<3>>& changes, std::vector<Removal_task>& tasks) {
  for(Removal_task& task : tasks)
    if(task.has_failed()) {
      task.state = Removal_task::State::REFUSED;
      task.is_hindered = std::any_of(changes.begin(), changes.end(), [&](const Box<3>& change) {
        return task.is_far_reaching || change.meets(task.reach);
      });
    }
}

/// removes handles along the loops that they have, and along others nearby, on a surface as it is.
static std::vector<Box<3>> remove_once(Execution execution,
                                       Surgery_mesh& mesh,
                                       std::vector<Removal_task>& tasks,
                                       Removal_effort effort,
                                       bool force,
                                       const std::function<void()>& ask) {
  constexpr std::size_t few = 2, many = 64, many_for_one = 8; // that was removed
  Removal_rounds remove(execution, mesh, force);
  const std::size_t left = number_left(tasks);
  const auto number_removed = [&] { return left - number_left(tasks); };
  remove(tasks, ask);
  // Of very many, as on a surface that crosses itself all over, it is not for the want of loops.
  if(effort == Removal_effort::GIVEN_LOOPS ||
     number_left(tasks) > many + many_for_one * number_removed())
    return remove.changes();
  if(effort != Removal_effort::MORE_LOOPS)
    remove_along_loops_nearby(execution, remove, mesh, tasks, Nearby_search(), ask);
  if(effort == Removal_effort::MORE_LOOPS || (number_left(tasks) <= few && number_removed() == 0))
    remove_along_loops_nearby(execution, remove, mesh, tasks, Nearby_search::wide(), ask);
  return remove.changes();
}

void remove_handles(Execution execution,
                    Surgery_mesh& mesh,
                    std::vector<Removal_task>& tasks,
                    Removal_effort effort,
                    bool force,
                    const std::function<void(double)>& ask) {
  using State = Removal_task::State;
  const auto ask_now = [&] {
    ask(double(number_with(State::REMOVED, tasks)) / double(tasks.size()));
  };
  for(Removal_task& task : tasks)
    task.forget_what_is_not_of(mesh);
  std::vector<Box<3>> changes;
  for(;;) {
    const std::vector<Box<3>> last = remove_once(execution, mesh, tasks, effort, force, ask_now);
    changes.insert(changes.end(), last.begin(), last.end());
    if(last.empty() || number_left(tasks) == 0 || effort == Removal_effort::GIVEN_LOOPS)
      break;
    mesh.forget_order();
    Loops_anew(execution, mesh).give_to(tasks);
  }
  give_up(changes, tasks);
  CGAL_postcondition(number_with(State::OPEN, tasks) == 0);
}

void try_to_remove_each(Execution execution,
                        Surgery_mesh& mesh,
                        std::vector<Removal_task>& tasks,
                        bool force,
                        const std::function<void(double)>& ask) {
  Removal_rounds remove(execution, mesh, force, Removal_rounds::Mode::EACH_ALONE);
  remove(tasks, [&] {
    ask(double(number_with(Removal_task::State::REMOVED, tasks)) / double(tasks.size()));
  });
  give_up(remove.changes(), tasks);
}

/// keeps necks that are no channels, as removing all of them on a copy of the mesh shows.
static void keep_what_is_no_channel(Execution execution,
                                    Surgery_mesh mesh,
                                    std::vector<Removal_task>& tasks,
                                    bool force) {
  std::vector<Removal_task> tried = tasks;
  const Index first_put_in = mesh.face_bound();
  Removal_rounds remove(execution, mesh, force);
  remove(tried, [] {});
  Parted_walls walls(execution, mesh, first_put_in, {&tried});
  for(std::size_t i = 0; i < tasks.size(); ++i)
    if(tried[i].state == Removal_task::State::REMOVED && !walls.was_channel(tried[i]))
      tasks[i].state = Removal_task::State::KEPT;
}

std::vector<Removal_task>
remove_necks(Execution execution, Surgery_mesh& mesh, const Removal_options& wanted) {
  const Surgery_graph graph(mesh);
  std::vector<Removal_task> tasks;
  for(const auto& neck :
      find_necks(execution, graph, graph.point(), Surgery_graph::Vertex_index_map(),
                 Surgery_mesh::Kernel(), wanted.maximal_neck_length, wanted.minimal_piece_share))
  {
    tasks.emplace_back();
    tasks.back().are_types_known = false;
    tasks.back().choices.push_back(loop_choice(neck, graph, Surgery_graph::Vertex_index_map()));
  }
  if(wanted.only_channels)
    keep_what_is_no_channel(execution, mesh, tasks, wanted.force);
  Removal_rounds remove(execution, mesh, wanted.force);
  remove(tasks, [] {});
  give_up(remove.changes(), tasks);
  return tasks;
}

} // namespace CGAL::Handle_tunnel_loops::internal
