// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_SURGERY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_SURGERY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Caps_in_vain.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Divided_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// One way to remove a handle, prepared and checked: whole faces that are taken out, or a narrow
/// strip along a curve, of faces divided along it; and caps that take their place.
class Handle_surgery
{
public:
  Handle_surgery(const Surgery_mesh& mesh, Cut_region region)
      : region_(std::move(region))
      , out_(region_->faces())
      , vertices_(vertices_of(mesh, out_))
      , reach_(box_of(mesh, out_)) {
    for(std::size_t i = 0; i < region_->number_of_borders(); ++i)
      for(Index h : region_->border(i))
        around_.push_back(mesh.face(mesh.twin(h)));
  }

  Handle_surgery(const Surgery_mesh& mesh, Curve_off_vertices curve)
      : curve_(std::move(curve))
      , out_(curve_->faces())
      , vertices_(vertices_of(mesh, out_))
      , reach_(box_of(mesh, out_)) {}

  /// the faces of the mesh that are to be replaced, in ascending order.
  const std::vector<Index>& out() const { return out_; }

  /// of these faces, in ascending order.
  const std::vector<Index>& vertices() const { return vertices_; }

  std::size_t number_of_handles() const { return region_ ? region_->number_of_handles() : 1; }

  /// whether handles are taken out with their surroundings, and no surface is cut.
  bool takes_all() const { return region_ && region_->number_of_borders() == 1; }

  /// where the surface is cut, if it is.
  Surface_cut cut(const Surgery_mesh& mesh) const {
    CGAL_precondition(!takes_all());
    return region_ ? cut_around(mesh, *region_) : cut_along(mesh, *curve_);
  }

  /// whether the mesh is as it was here: all faces that are to be replaced, and those around them,
  /// are there.
  bool is_up_to_date(const Surgery_mesh& mesh) const {
    const auto is_alive = [&](Index f) { return mesh.is_alive(f); };
    return std::all_of(out_.begin(), out_.end(), is_alive) &&
           std::all_of(around_.begin(), around_.end(), is_alive);
  }

  // ---- in a round

  /// looks for caps that may take the place of what is taken out, the best ones first, unless it is
  /// known that they are in vain. How far they are from a wall that is closed flush at its mouths
  /// is no matter.
  void find_caps(const Surgery_mesh& mesh,
                 const Mesh_contacts& contacts,
                 const Shape_judge& judge,
                 Intended_change intended,
                 const std::vector<Caps_in_vain>& known) {
    intended.may_be_far = are_mouths_flush(mesh);
    is_harmless = is_for_now_ = false;
    has_caps_ = false;
    obstacle_ = Obstacle();
    former_.reset();
    in_vain_ = {out_, curve_ ? curve_->crossings() : std::vector<Edge_crossing>(), {}, intended};
    if(is_known_to_be_in_vain(mesh, known))
      return;
    if(intended.may_cross)
      former_ = std::make_unique<Former_contacts>(mesh, contacts, out_);
    // Which is known sooner than what caps meet.
    if(!(former_ && curve_ && former_->are_likely_too_many()))
      make_caps(mesh, contacts, judge, intended);
    if(has_caps_)
      in_vain_.reset();
    else
      describe_failure(mesh);
    former_.reset();
  }

  bool has_caps() const { return has_caps_; }

  /// what holds the faces that are to be replaced, and all caps that were looked at.
  const Box<3>& reach() const { return reach_; }

  /// to caps, if there are none.
  const Obstacle& obstacle() const { return obstacle_; }

  /// with the caps.
  const Patch& patch() const {
    CGAL_precondition(has_caps_);
    return patch_;
  }

  const Shape_change& change() const { return change_; }

  /// what was in the way of all caps, if they were looked for in vain and that was not known.
  const std::optional<Caps_in_vain>& in_vain() const { return in_vain_; }

  std::vector<Removal_task*> companions; ///< whose handles are in the region as well
  std::size_t number_inside = 0;         ///< of these with all of their loops, which come first
  bool is_harmless = false; ///< to the pieces of the surface, with all others that are so

private:
  static Box<3> box_of(const Surgery_mesh& mesh, const std::vector<Index>& faces) {
    Box<3> box = Box<3>::empty();
    for(Index f : faces)
      box.extend(placed_triangle(mesh, f).box());
    return box;
  }

  // The first ones that nothing is in the way of.
  void make_caps(const Surgery_mesh& mesh,
                 const Mesh_contacts& contacts,
                 const Shape_judge& judge,
                 const Intended_change& intended) {
    const auto is_wanted = [&](const Patch& patch) {
      if(const auto obstacle = obstacle_to(patch, mesh, contacts, judge, intended)) {
        obstacle_.take(*obstacle);
        return false;
      }
      patch_ = patch;
      return has_caps_ = true;
    };
    if(region_)
      for_each_cap(mesh, *region_, is_wanted);
    else
      for(const auto side : sides_of_membranes(intended, judge.outward()))
        if(!has_caps_)
          for_each_membrane(mesh, *curve_, Divided_strip(mesh, *curve_), side, is_wanted);
  }

  // Solid is taken away between membranes inside.
  static std::vector<Polygon_in_space::At_sides> sides_of_membranes(const Intended_change& intended,
                                                                    double outward) {
    std::vector<Polygon_in_space::At_sides> sides;
    if(intended.may_remove)
      sides.push_back(outward > 0. ? Polygon_in_space::INSIDE : Polygon_in_space::OUTSIDE);
    if(intended.may_add)
      sides.push_back(outward > 0. ? Polygon_in_space::OUTSIDE : Polygon_in_space::INSIDE);
    return sides;
  }

  bool are_mouths_flush(const Surgery_mesh& mesh) const {
    if(!region_ || takes_all())
      return false;
    for(std::size_t i = 0; i < region_->number_of_borders(); ++i)
      if(!is_flush(rim_of(mesh, *region_, i)))
        return false;
    return true;
  }

  bool caps_meet_each_other(const Patch& patch, const Placed_patch& placed) {
    return placed.meets_itself([&](Index, Index j) {
      return former_ && former_->are_own() &&
             (!placed.is_part(j) || former_->are_of_own(patch.parents[j]));
    });
  }

  bool caps_meet_surface(const Placed_patch& placed, const Mesh_contacts& contacts) {
    return contacts.meets(placed, out_, [&](Index f) {
      const bool may_meet = former_ && former_->are_with(f);
      if(!may_meet)
        in_vain_->met.push_back(f);
      return may_meet;
    });
  }

  // Whether the same caps were in vain before, and all that was in the way is there still; or such
  // that may cross nothing were, and not because of what the surface crosses here.
  bool is_known_to_be_in_vain(const Surgery_mesh& mesh, const std::vector<Caps_in_vain>& known) {
    for(const Caps_in_vain& before : known) {
      if(!before.is_like(*in_vain_) || !before.holds(mesh))
        continue;
      const bool is_same = before.intended.may_cross == in_vain_->intended.may_cross;
      if(is_same) {
        obstacle_ = before.obstacle;
        reach_.extend(before.reach);
      }
      if(is_same || (!before.intended.may_cross && !may_help(before, mesh))) {
        in_vain_.reset();
        return true;
      }
    }
    return false;
  }

  // Whether any caps that were in vain may not be so if they may cross what the surface crosses
  // here. To ask for what was in the way takes far less than to make the caps once more.
  bool may_help(const Caps_in_vain& before, const Surgery_mesh& mesh) const {
    const Placed_patch placed(mesh, patch_of(mesh, out_));
    return (before.met_each_other && placed.meets_itself([](Index, Index) { return false; })) ||
           std::any_of(before.met.begin(), before.met.end(),
                       [&](Index f) { return placed.meets(placed_triangle(mesh, f)); });
  }

  // Where the surface crosses itself all over, all that it crosses tells. What may not be so later
  // is not noted.
  void describe_failure(const Surgery_mesh& mesh) {
    if(former_ && former_->are_known_to_be_too_many()) {
      const std::vector<Index> met = former_->met();
      in_vain_->met.insert(in_vain_->met.end(), met.begin(), met.end());
    }
    in_vain_->obstacle = obstacle_;
    in_vain_->reach = reach_;
    if(region_) // caps are made to fit two rings of faces around them
      in_vain_->around = Cut_region::faces_at(
          mesh, vertices_of(mesh, Cut_region::faces_at(mesh, region_->border_vertices(mesh))));
    if(is_for_now_)
      in_vain_.reset();
  }

  // Where the surface was in the way of other caps it is looked at first: it may well be so again,
  // and says more than what the caps do to each other.
  std::optional<Obstacle>
  contact_of_caps(const Patch& patch, const Placed_patch& placed, const Mesh_contacts& contacts) {
    const Obstacle each_other{Obstacle::CAPS_CROSS, "the caps would intersect each other"},
        surface{Obstacle::SURFACE_IN_THE_WAY, "the caps would intersect the surface"};
    if(!placed.has_areas())
      return each_other;
    const bool is_surface_first = obstacle_.kind >= Obstacle::SURFACE_IN_THE_WAY;
    if(is_surface_first && caps_meet_surface(placed, contacts))
      return surface;
    if(caps_meet_each_other(patch, placed)) {
      in_vain_->met_each_other = true;
      return each_other;
    }
    if((!is_surface_first && caps_meet_surface(placed, contacts)) ||
       (former_ && former_->are_too_many()))
      return surface;
    return std::nullopt;
  }

  std::optional<Obstacle> obstacle_to(const Patch& patch,
                                      const Surgery_mesh& mesh,
                                      const Mesh_contacts& contacts,
                                      const Shape_judge& judge,
                                      const Intended_change& intended) {
    const Placed_patch placed(mesh, patch);
    reach_.extend(placed.reach());
    if(const auto obstacle = contact_of_caps(patch, placed, contacts))
      return obstacle;
    const std::size_t crossings = former_ ? number_of_new_crossings(mesh, placed, contacts) : 0;
    if(crossings > 0 && !judge.is_forced()) {
      is_for_now_ = true; // what comes may cross what is taken out
      return Obstacle{Obstacle::MORE_CROSSINGS,
                      "the surface, which intersects itself there, would do so in " +
                          std::to_string(crossings) + " more pairs of faces"};
    }
    Judged_change change = judge.change(mesh, out_, patch, intended);
    change.crossings = crossings;
    const std::string why = judge.objection(change, intended);
    if(!why.empty())
      return Obstacle{Obstacle::SHAPE, why};
    change_ = change;
    return std::nullopt;
  }

  // How many more pairs of faces cross. What parts of faces cross is what these have crossed.
  std::size_t number_of_new_crossings(const Surgery_mesh& mesh,
                                      const Placed_patch& placed,
                                      const Mesh_contacts& contacts) const {
    const std::size_t number = contacts.number_of_crossings(placed, out_);
    if(number == 0 || curve_) // along which all faces are divided
      return number;
    const Placed_patch former(mesh, patch_of(mesh, out_));
    return number - (std::min)(number, contacts.number_of_crossings(former, out_));
  }

  // One of them.
  std::optional<Cut_region> region_;
  std::optional<Curve_off_vertices> curve_;
  std::vector<Index> out_, vertices_;
  Box<3> reach_;
  std::vector<Index> around_; // faces beyond the borders of a region
  // Of this round.
  std::unique_ptr<Former_contacts> former_; // if caps may cross what there is
  bool has_caps_ = false;
  bool is_for_now_ = false; // that there are none
  Obstacle obstacle_;
  std::optional<Caps_in_vain> in_vain_;
  Patch patch_;
  Shape_change change_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_SURGERY_H
