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
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

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
  explicit Removal_candidate(Removal_task& task)
      : task_(&task)
      , is_damaged_(task.choices.size(), 0)
      , separates_(task.choices.size(), 0)
      , obstacles_(task.choices.size(), Obstacle{Obstacle::NO_LOOP, "there is no loop"}) {}

  /// to be called once, before all else.
  void find_loops(const Surgery_mesh& mesh) {
    CGAL_precondition(walks_.empty());
    std::vector<std::pair<double, std::size_t>> allowed; // by the discs across the loops
    for(std::size_t i = 0; i < task_->choices.size(); ++i) {
      const Loop_choice& loop = task_->choices[i];
      walks_.push_back(simple_part(led_off_boundary(mesh, walk_beside(mesh, loop.places))));
      lengths_.push_back(length(mesh, walks_.back()));
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

  /// of the present choice, if there is one.
  std::optional<Handle_surgery>& surgery() { return surgery_; }

  /// the loop that the present choice is measured by: the longest one of what is taken out.
  std::size_t measure() const {
    return choice().takes_both_loops() ? task_->longest_choice() : choice().loop;
  }

  /// what the present choice may do to the shape.
  Intended_change intended_change() const {
    constexpr double most_displacement = 0.5;
    const Loop_choice& loop = task_->choices[choice().loop];
    const bool is_either = choice().takes_both_loops() || !task_->are_types_known;
    double length = task_->choices[measure()].length;
    if(choice().takes_both_loops())
      for(const Removal_task* companion : surgery_->companions)
        length = (std::max)(length, companion->choices[companion->longest_choice()].length);
    return {is_either || loop.type == Loop_type::HANDLE,
            is_either || loop.type == Loop_type::TUNNEL, most_displacement * length};
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
    if(surgery_ && !is_narrow_ && surgery_->is_up_to_date(mesh))
      return;
    is_narrow_ = false;
    surgery_.reset();
    while(!is_done()) {
      if(!is_out_of_question() && (surgery_ = find_surgery(mesh, layout)))
        return;
      fail(why_no_surgery(mesh));
    }
  }

  /// the present choice once more, with room for the regions that are claimed by now.
  void propose_again(const Surgery_mesh& mesh, const Region_layout& layout) {
    is_narrow_ = true;
    surgery_ = find_surgery(mesh, layout);
  }

  /// gives the present choice up, and the task if that is the last one.
  void fail(const Obstacle& obstacle) {
    CGAL_precondition(!is_done());
    obstacles_[choice().loop].take(obstacle);
    surgery_.reset();
    if(++next_ < choices_.size())
      return;
    task_->reasons.clear();
    for(const Obstacle& worst : obstacles_)
      task_->reasons.push_back(worst.why);
    task_->state = is_any_damaged() ? Removal_task::State::DAMAGED : Removal_task::State::REFUSED;
  }

  /// gives the loop of the present choice up: all strips along it separate the surface.
  void fail_along_loop() {
    separates_[choice().loop] = choice().style != Region_choice::BORE;
    fail({Obstacle::TOPOLOGY, separates_the_surface});
  }

  /// leads a loop around what has taken the place of another handle. It is given up if it comes to
  /// a vertex twice then, or becomes much longer. Returns whether it was led.
  bool lead_around(const Surgery_mesh& mesh, const Detour& detour, std::size_t loop) {
    CGAL_precondition(!is_done());
    constexpr double most_growth = 1.5;
    Closed_walk& walk = walks_[loop];
    if(walk.size() < 3 || is_intact(mesh, walk))
      return false;
    walk = led_off_boundary(mesh, shortened(mesh, detour.around(walk)));
    if(!is_simple(walk) || length(mesh, walk) > most_growth * lengths_[loop])
      walk.clear();
    is_damaged_[loop] = true;
    return !walk.empty();
  }

private:
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

  // Where the loop of the present choice was found, if it is there still; or else beside its walk.
  std::optional<Curve_off_vertices> curve(const Surgery_mesh& mesh) const {
    const std::size_t loop = choice().loop;
    std::optional<Curve_off_vertices> curve =
        Curve_off_vertices::beside(mesh, task_->choices[loop].places);
    return curve ? curve : Curve_off_vertices::beside(mesh, places_of(walks_[loop]));
  }

  std::optional<Handle_surgery> find_surgery(const Surgery_mesh& mesh,
                                             const Region_layout& layout) const {
    const bool needs_curve =
        choice().style == Region_choice::STRIP || choice().style == Region_choice::BORE;
    return layout.surgery(choice(), needs_curve ? curve(mesh) : std::nullopt, walks_, reserved_);
  }

  // Whether the choice is along loops that are lost, or known to separate the surface.
  bool is_out_of_question() const {
    if(separates_[choice().loop] && !choice().takes_both_loops())
      return true;
    const bool needs_walk =
        choice().style != Region_choice::STRIP && choice().style != Region_choice::BORE;
    for(std::size_t i = 0; i < walks_.size(); ++i)
      if(needs_walk && (i == choice().loop || choice().takes_both_loops()) && walks_[i].size() < 3)
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
      return {Obstacle::NO_REGION, "the loop comes to the boundary"};
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
  std::vector<Closed_walk> walks_;
  std::vector<double> lengths_; // of these at first
  std::vector<Region_choice> choices_;
  std::vector<char> is_damaged_;    // by choice, also if it could be led around
  std::vector<char> separates_;     // by choice
  std::vector<Obstacle> obstacles_; // by choice, what says most
  std::size_t next_ = 0;
  std::vector<Index> reserved_; // in ascending order
  std::optional<Handle_surgery> surgery_;
  bool is_narrow_ = false; // because of regions of the round
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REMOVAL_CANDIDATE_H
