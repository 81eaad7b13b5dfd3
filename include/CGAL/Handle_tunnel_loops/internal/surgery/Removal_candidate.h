// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Detour.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Handle_surgery.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Region_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Region_layout.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rings_around.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Ways_tried.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/region_choices.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A handle that is to be removed, with the loops and regions that are left to be tried, one after
/// the other.
class Removal_candidate
{
public:
  /// what comes of its choices is noted with the \p ways, and what these have given up is left out.
  Removal_candidate(Removal_task& task, Ways_tried& ways)
      : task_(&task)
      , ways_(&ways)
      , is_damaged_(task.choices.size(), 0)
      , separates_(task.choices.size(), 0)
      , obstacles_(task.choices.size(), Obstacle{Obstacle::NO_LOOP, "no loop"}) {}

  /// to be called once, before all else.
  void find_loops(const Surgery_mesh& mesh) {
    CGAL_precondition(walks_.empty());
    std::vector<std::pair<double, std::size_t>> allowed; // by the discs across the loops
    for(std::size_t i = 0; i < task_->choices.size(); ++i) {
      const Loop_choice& loop = task_->choices[i];
      walks_.push_back(simple_part(led_off_boundary(mesh, walk_beside(mesh, loop.places))));
      lengths_.push_back(internal::length(mesh, walks_.back()));
      for(Index v : walks_.back())
        task_->reach.extend(box_at(mesh.point(v)));
      if(loop.is_allowed)
        allowed.push_back({task_->has_both_loops() ? cost_of_disc(mesh, loop.places) : 0., i});
    }
    std::sort(allowed.begin(), allowed.end());
    std::vector<std::size_t> order;
    for(const auto& loop : allowed)
      order.push_back(loop.second);
    choices_ = region_choices(*task_, order);
  }

  Removal_task& task() const { return *task_; }

  bool is_done() const { return task_->is_done(); }

  /// by choice; those with less than three vertices are none.
  const std::vector<Closed_walk>& walks() const { return walks_; }

  const Region_choice& choice() const {
    CGAL_precondition(next_ < choices_.size());
    return choices_[next_];
  }

  /// the walk of the other loop, if there is one.
  Closed_walk partner() const {
    return task_->has_both_loops() ? walks_[1 - choice().loop] : Closed_walk();
  }

  /// what share of the loops comes to some vertices, in ascending order: 1 if all do.
  double share_in(const std::vector<Index>& vertices) const {
    std::size_t number = 0, number_in = 0;
    for(const Closed_walk& walk : walks_) {
      number += walk.size();
      number_in += static_cast<std::size_t>(
          std::count_if(walk.begin(), walk.end(), [&](Index v) { return is_in(v, vertices); }));
    }
    return number == 0 ? 0. : static_cast<double>(number_in) / static_cast<double>(number);
  }

  /// of the present choice, if there is one.
  std::optional<Handle_surgery>& surgery() { return surgery_; }

  /// the vertices of the faces that are to be replaced, along either loop if both are to be
  /// compared.
  bool is_free(const Region_layout& layout) const {
    return layout.is_free(surgery_->vertices()) && (!rival_ || layout.is_free(rival_->vertices()));
  }
  void claim(Region_layout& layout) const {
    layout.claim(surgery_->vertices());
    if(rival_)
      layout.claim(rival_->vertices());
  }

  /// that of the two that says what the present choice is: of what is taken out whole, the longer
  /// one.
  std::size_t loop() const {
    return choice().takes_both_loops() ? task_->longest_choice() : choice().loop;
  }

  /// the length that the present choice is measured by: of the longest loop of what is taken out.
  double length() const { return length(choice(), *surgery_); }

  /// what is to be looked at in this round: the surgery of the present choice, and of strips along
  /// both loops also that along the other one.
  struct Trial
  {
    Handle_surgery* surgery;
    Intended_change intended;
    const std::vector<Caps_in_vain>& known; ///< what was tried
  };
  std::vector<Trial> trials() {
    std::vector<Trial> trials = {
        {&*surgery_, intended_change(choice(), *surgery_), *task_->in_vain}};
    if(rival_)
      trials.push_back({&*rival_, intended_change(choices_[next_ + 1], *rival_), *task_->in_vain});
    return trials;
  }

  /// after caps were looked for: of strips along both loops, takes the better one.
  void take_better_one() {
    if(!rival_)
      return;
    if(!rival_->has_caps()) {
      note_failure(*rival_);
      obstacles_[choices_[next_ + 1].loop].take(rival_->obstacle());
      note_reach();
      choices_.erase(choices_.begin() + static_cast<std::ptrdiff_t>(next_) + 1);
    } else if(!surgery_->has_caps() || is_better(*rival_, *surgery_)) {
      note_failure(*surgery_);
      std::swap(choices_[next_], choices_[next_ + 1]);
      std::swap(surgery_, rival_);
    }
    rival_.reset();
  }

  /// the loop of the present choice wants to keep its place.
  void reserve(Region_layout& layout) {
    CGAL_precondition(!is_done());
    reserved_ = walks_[choice().loop];
    make_set(reserved_);
    layout.reserve(reserved_);
  }

  /// goes on to the first choice, from the present one on, of which there is a region.
  void propose(const Surgery_mesh& mesh, const Region_layout& layout) {
    if(surgery_ && !is_narrow_ && surgery_->is_up_to_date(mesh) &&
       (!rival_ || rival_->is_up_to_date(mesh)))
      return;
    is_narrow_ = false;
    drop_surgery();
    Rings_around rings = rings_around(layout);
    while(!is_done() && !surgery_) {
      if(ways_->is_given_up(choice()))
        go_on();
      else if(is_out_of_question(choice()) ||
              !(surgery_ = find_surgery(choice(), mesh, layout, rings)))
        fail(why_no_surgery(mesh));
    }
    if(!is_done() && is_strip_along_either_loop())
      rival_ = find_surgery(choices_[next_ + 1], mesh, layout, rings);
  }

  /// the present choice once more, with room for the regions that are claimed by now.
  void propose_again(const Surgery_mesh& mesh, const Region_layout& layout) {
    is_narrow_ = true;
    if(!layout.is_free(vertices_of(mesh, Cut_region::faces_at(mesh, walks_[choice().loop]))))
      return; // which none is without
    Rings_around rings = rings_around(layout);
    surgery_ = find_surgery(choice(), mesh, layout, rings);
  }

  /// gives the present choice up, and the task if that is the last one.
  void fail(const Obstacle& obstacle) {
    CGAL_precondition(!is_done());
    obstacles_[choice().loop].take(obstacle);
    ways_->note_failure(choice());
    note_reach();
    // Whether a loop separates the surface is decided anywhere.
    task_->is_far_reaching |= obstacle.kind == Obstacle::TOPOLOGY;
    const bool is_alone = !surgery_ || surgery_->number_of_handles() == 1;
    if(choice().style == Region_choice::BORE && choice().rings > 0 && is_alone &&
       choices_[next_ + 1].style == Region_choice::BORE)
      ++next_; // it would be the same
    if(surgery_ && !surgery_->has_caps())
      note_failure(*surgery_);
    drop_surgery();
    go_on();
  }

  /// gives the loop of the present choice up: all strips along it separate the surface.
  void fail_along_loop() {
    separates_[choice().loop] = choice().style != Region_choice::BORE;
    fail({Obstacle::TOPOLOGY, separates_the_surface});
  }

  /// leads a loop around what has taken the place of another handle. It is given up if it comes to
  /// a vertex twice then, or becomes much longer. Returns whether it was led.
  bool lead_around(const Surgery_mesh& mesh, const Detour& detour, std::size_t loop) {
    CGAL_precondition(task_->is_left());
    constexpr double most_growth = 1.5;
    Closed_walk& walk = walks_[loop];
    if(walk.size() < 3 || is_intact(mesh, walk))
      return false;
    walk = led_off_boundary(mesh, shortened(mesh, detour.around(walk)));
    if(!is_simple(walk) || internal::length(mesh, walk) > most_growth * lengths_[loop])
      walk.clear();
    is_damaged_[loop] = true;
    return !walk.empty();
  }

private:
  // To the next choice, if there is one.
  void go_on() {
    if(++next_ < choices_.size())
      return;
    task_->reasons.clear();
    for(const Obstacle& worst : obstacles_)
      task_->reasons.push_back(worst.why);
    task_->state = is_any_damaged() ? Removal_task::State::DAMAGED : Removal_task::State::REFUSED;
    task_->is_far_reaching |= is_any_damaged();
  }

  void drop_surgery() {
    surgery_.reset();
    rival_.reset();
  }

  void note_failure(const Handle_surgery& surgery) {
    if(surgery.in_vain())
      task_->in_vain->push_back(*surgery.in_vain());
  }

  void note_reach() {
    for(const auto* tried : {&surgery_, &rival_})
      if(*tried)
        task_->reach.extend((*tried)->reach());
  }

  // That which changes the volume less; one that leaves a sharp edge, only if it does by far: at
  // four times in each direction, handles of objects would be filled because of an edge. As the
  // present loop has the rounder disc, it needs no more than be about as good.
  static bool is_better(const Handle_surgery& rival, const Handle_surgery& present) {
    constexpr double about = 1.1, by_far = 8.;
    const bool is_sharp = rival.change().has_sharp_edge();
    const double factor = is_sharp == present.change().has_sharp_edge() ? about
                          : is_sharp                                    ? by_far
                                                                        : 1. / by_far;
    return factor * volume(rival) < volume(present);
  }

  static double volume(const Handle_surgery& surgery) {
    return surgery.change().volume_removed + surgery.change().volume_added;
  }

  // What a choice may do to the shape.
  Intended_change intended_change(const Region_choice& choice,
                                  const Handle_surgery& surgery) const {
    const bool is_either = choice.takes_both_loops() || !task_->are_types_known;
    const Loop_type type = task_->choices[choice.loop].type;
    return {is_either || type == Loop_type::HANDLE, is_either || type == Loop_type::TUNNEL,
            length(choice, surgery), false, choice.may_cross};
  }

  double length(const Region_choice& choice, const Handle_surgery& surgery) const {
    if(!choice.takes_both_loops())
      return task_->choices[choice.loop].length;
    double length = task_->choices[task_->longest_choice()].length;
    for(std::size_t i = 0; i < surgery.number_inside; ++i) {
      const Removal_task& companion = *surgery.companions[i];
      length = (std::max)(length, companion.choices[companion.longest_choice()].length);
    }
    return length;
  }

  // Whether the next choice is one along the other loop, so that they are compared.
  bool is_strip_along_either_loop() const {
    return task_->has_both_loops() && choice().style == Region_choice::STRIP &&
           next_ + 1 < choices_.size() && choices_[next_ + 1].style == Region_choice::STRIP &&
           !is_out_of_question(choices_[next_ + 1]);
  }

  // The area of triangles from the centre of a loop, over the square of how round they are: rather
  // than being slit from a hole to the rim, a flange is filled.
  static double cost_of_disc(const Surgery_mesh& mesh, const std::vector<Place_on_edge>& places) {
    using Shift = Surgery_mesh::Kernel::Vector_3;
    std::vector<Surgery_mesh::Point> points;
    Shift sum(NULL_VECTOR);
    for(const Place_on_edge& place : places) {
      points.push_back(point_at(mesh, place));
      sum = sum + (points.back() - ORIGIN);
    }
    const Surgery_mesh::Point center = ORIGIN + sum / static_cast<double>(points.size());
    double area = 0., length = 0.;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Surgery_mesh::Point& next = points[(i + 1) % points.size()];
      area += std::sqrt(CGAL::squared_area(center, points[i], next));
      length += std::sqrt(CGAL::squared_distance(points[i], next));
    }
    const double area_of_circle = length * length / (4. * CGAL_PI);
    return area > 0. ? area_of_circle * (area_of_circle / area) : 0.;
  }

  // Where a loop was found, if it is there still; or else beside its walk.
  std::optional<Curve_off_vertices> curve(std::size_t loop, const Surgery_mesh& mesh) const {
    std::optional<Curve_off_vertices> curve =
        Curve_off_vertices::beside(mesh, task_->choices[loop].places);
    return curve ? curve : Curve_off_vertices::beside(mesh, places_of(walks_[loop]));
  }

  std::optional<Handle_surgery> find_surgery(const Region_choice& choice,
                                             const Surgery_mesh& mesh,
                                             const Region_layout& layout,
                                             Rings_around& rings) const {
    return layout.surgery(choice, choice.is_along_curve() ? curve(choice.loop, mesh) : std::nullopt,
                          walks_, reserved_, rings);
  }

  Rings_around rings_around(const Region_layout& layout) const {
    std::vector<Index> vertices;
    for(const Closed_walk& walk : walks_)
      vertices.insert(vertices.end(), walk.begin(), walk.end());
    return layout.rings_around(std::move(vertices));
  }

  // Whether a choice is along loops that are lost, or known to separate the surface.
  bool is_out_of_question(const Region_choice& choice) const {
    if(separates_[choice.loop] && !choice.takes_both_loops())
      return true;
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if(!choice.is_along_curve() && (i == choice.loop || choice.takes_both_loops()) &&
         walks_[i].size() < 3)
        return true;
    return false;
  }

  Obstacle why_no_surgery(const Surgery_mesh& mesh) const {
    const std::size_t loop = choice().loop;
    if(separates_[loop])
      return {Obstacle::TOPOLOGY, separates_the_surface};
    if(walks_[loop].size() < 3)
      return {Obstacle::NO_REGION, is_damaged_[loop] ? "another handle was removed across the loop"
                                                     : "the loop is not simple"};
    if(is_on_boundary(mesh, walks_[loop]))
      return {Obstacle::NO_REGION, "the loop touches the boundary"};
    return {Obstacle::NO_REGION, "the mesh is too coarse along the loop"};
  }

  bool is_any_damaged() const {
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if(is_damaged_[i] && task_->choices[i].is_allowed)
        return true;
    return false;
  }

  static constexpr const char* separates_the_surface = "the loop separates the surface";

  Removal_task* task_;
  Ways_tried* ways_;
  std::vector<Closed_walk> walks_;
  std::vector<double> lengths_; // of these at first
  std::vector<Region_choice> choices_;
  std::vector<char> is_damaged_;    // by choice, also if it could be led around
  std::vector<char> separates_;     // by choice
  std::vector<Obstacle> obstacles_; // by choice, what says most
  std::size_t next_ = 0;
  std::vector<Index> reserved_; // in ascending order
  std::optional<Handle_surgery> surgery_;
  std::optional<Handle_surgery> rival_; // of the choice after the present one
  bool is_narrow_ = false;              // because of regions of the round
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H
