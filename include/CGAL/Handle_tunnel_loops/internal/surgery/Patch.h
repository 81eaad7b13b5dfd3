// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PATCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PATCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index_table.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Box_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Placed_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/near_pairs.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Faces that take the place of others. Corners are vertices of the mesh, or, from `first_own` on,
/// points of the patch.
struct Patch
{
  static constexpr Index first_own = Index(1) << 31;

  std::vector<Surgery_mesh::Point> points;
  std::vector<Surgery_mesh::Face> faces;
  /// the first faces may be parts of faces of the mesh, and this says of which.
  std::vector<Index> parents = {};
  /// after them come those of one cap after the other, and this says where each begins.
  std::vector<std::size_t> caps = {};

  std::size_t end_of_cap(std::size_t i) const {
    return i + 1 < caps.size() ? caps[i + 1] : faces.size();
  }

  const Surgery_mesh::Point& point(const Surgery_mesh& mesh, Index v) const {
    return v < first_own ? mesh.point(v) : points[v - first_own];
  }

  Placed_triangle placed(const Surgery_mesh& mesh, std::size_t i) const {
    const Surgery_mesh::Face& f = faces[i];
    return {f, {point(mesh, f[0]), point(mesh, f[1]), point(mesh, f[2])}};
  }
};

/// faces of a mesh as they are.
inline Patch patch_of(const Surgery_mesh& mesh, const std::vector<Index>& faces) {
  Patch patch;
  for(Index f : faces)
    patch.faces.push_back(mesh.corners(f));
  return patch;
}

/// puts a patch into the place of faces in ascending order. Returns the number of its first face.
inline Index put_in_place(Surgery_mesh& mesh, const std::vector<Index>& faces, const Patch& patch) {
  const Index shift = mesh.vertex_bound();
  for(const Surgery_mesh::Point& p : patch.points)
    mesh.add_vertex(p);
  std::vector<Surgery_mesh::Face> in = patch.faces;
  for(Surgery_mesh::Face& f : in)
    for(Index& v : f)
      if(v >= Patch::first_own)
        v = v - Patch::first_own + shift;
  return mesh.replace(faces, in, patch.parents);
}

/// The faces of a patch where they lie. Parts of faces of the mesh may meet what these meet.
class Placed_patch
{
public:
  /// \p first is added to the numbers of the patch's own points, to tell those of two patches
  /// apart.
  Placed_patch(const Surgery_mesh& mesh, const Patch& patch, Index first = 0)
      : axes_(mesh.box_axes()) {
    for(std::size_t i = 0; i < patch.faces.size(); ++i) {
      triangles_.push_back(patch.placed(mesh, i));
      for(Index& v : triangles_.back().vertices)
        if(v >= Patch::first_own)
          v += first;
      boxes_.push_back(axes_.box(triangles_.back().corners()));
      box_.extend(boxes_.back());
      reach_.extend(triangles_.back().box());
    }
    for(Index f : patch.parents)
      parents_.push_back(placed_triangle(mesh, f));
  }

  const std::vector<Placed_triangle>& triangles() const { return triangles_; }

  /// along the axes of the mesh; the second is that of all.
  const Box<3>& box(std::size_t i) const { return boxes_[i]; }
  const Box<3>& box() const { return box_; }

  /// along those of the coordinates.
  const Box<3>& reach() const { return reach_; }

  /// those that are parts of faces of the mesh come first.
  std::size_t number_of_parts() const { return parents_.size(); }

  /// whether one of the triangles meets a face that is not of the patch, and did not before.
  bool meets(std::size_t i, const Placed_triangle& face) const {
    return are_in_contact(triangles_[i], face) &&
           !(is_part(i) && are_in_contact(parents_[i], face));
  }

  bool meets(const Placed_triangle& face) const {
    const Box<3> box = axes_.box(face.corners());
    for(std::size_t i = 0; i < triangles_.size(); ++i)
      if(boxes_[i].meets(box) && meets(i, face))
        return true;
    return false;
  }

  bool meets(const Placed_patch& other) const {
    if(!box_.meets(other.box_))
      return false;
    return placed_boxes().any_meeting(
        other.placed_boxes(), [this](Index i) { return boxes_[i]; },
        [&](Index j) { return other.boxes_[j]; },
        [&](Index i, Index j, std::size_t) {
          return meets(i, other.triangles_[j]) && !(is_part(i) && other.is_part(j));
        });
  }

  /// whether all triangles have an area, but for parts of faces.
  bool has_areas() const {
    return std::none_of(triangles_.begin() + static_cast<std::ptrdiff_t>(parents_.size()),
                        triangles_.end(),
                        [](const Placed_triangle& t) { return t.is_degenerate(); });
  }

  /// whether a triangle meets another one, but for parts of faces; or for those for which
  /// `may_meet(i, j)`. Near linear, but for an unlimited budget, of which each pair is asked for
  /// once.
  template <typename Predicate> bool meets_itself(const Predicate& may_meet) const {
    return meets_itself(may_meet, Pair_budget(triangles_.size()));
  }
  template <typename Predicate>
  bool meets_itself(const Predicate& may_meet, Pair_budget budget) const {
    const Placed_boxes placed = placed_boxes();
    const auto box = [this](Index i) { return boxes_[i]; };
    // Parts come first, and do not meet each other.
    const auto meet = [&](Index i, Index j) {
      return i > j && !is_part(i) && are_in_contact(triangles_[i], triangles_[j]) &&
             !may_meet(i, j);
    };
    const auto is_over_or_meet = [&](Index i, Index j, std::size_t done) {
      return budget.is_spent(done) || meet(i, j);
    };
    const bool is_found = placed.any_meeting(placed, box, box, is_over_or_meet);
    if(!budget.is_over())
      return is_found;
    if(const auto pairs = near_pairs(triangles_))
      return std::any_of(pairs->begin(), pairs->end(),
                         [&](const auto& pair) { return meet(pair.first, pair.second); });
    budget = Pair_budget::unlimited();
    return placed.any_meeting(placed, box, box, is_over_or_meet);
  }

  /// how many pairs of triangles cross each other, but for two parts of faces.
  std::size_t number_of_crossings() const {
    std::size_t number = 0;
    const Placed_boxes placed = placed_boxes();
    const auto box = [this](Index i) { return boxes_[i]; };
    placed.any_meeting(placed, box, box, [&](Index i, Index j, std::size_t) {
      number += i > j && !is_part(i) && are_crossing(triangles_[i], triangles_[j]);
      return false;
    });
    return number;
  }

  /// whether a triangle is part of a face of the mesh.
  bool is_part(std::size_t i) const { return i < parents_.size(); }

  Placed_boxes placed_boxes() const {
    return Placed_boxes(Execution(), boxes_.size(), [this](std::size_t i) { return boxes_[i]; });
  }

private:
  Box_axes axes_;
  std::vector<Placed_triangle> triangles_, parents_;
  std::vector<Box<3>> boxes_; // of the triangles
  Box<3> box_ = Box<3>::empty(), reach_ = Box<3>::empty();
};

/// Finds which patches meet a face of the mesh that stays.
class Mesh_contacts
{
public:
  explicit Mesh_contacts(const Surgery_mesh& mesh)
      : mesh_(mesh) {}

  /// takes the faces that have come since into account, which is linear in their number as a rule:
  /// they make a layer by themselves, with layers before that are no larger. So there are few
  /// layers, and no face is put into one more often than that.
  void update(Execution execution) {
    const Index end = mesh_.face_bound();
    Index begin = layers_.empty() ? 0 : layers_.back().end;
    if(begin == end)
      return;
    while(!layers_.empty() && layers_.back().end - layers_.back().begin <= end - begin) {
      begin = layers_.back().begin;
      layers_.pop_back();
    }
    layers_.push_back({begin, end, boxes(execution, begin, end)});
  }

  /// whether a patch meets a face that is not in a set of those that it takes the place of; but for
  /// those that `may_meet(f)`. Near linear in the number of faces near the patch, but for an
  /// unlimited budget, of which each pair is asked for once.
  template <typename Predicate>
  bool
  meets(const Placed_patch& patch, const std::vector<Index>& out, const Predicate& may_meet) const {
    return meets(patch, out, may_meet, Pair_budget(patch.triangles().size()));
  }
  template <typename Predicate>
  bool meets(const Placed_patch& patch,
             const std::vector<Index>& out,
             const Predicate& may_meet,
             const Pair_budget& budget) const {
    CGAL_precondition(!layers_.empty() && layers_.back().end == mesh_.face_bound());
    const Placed_boxes boxes_of_patch = patch.placed_boxes();
    return std::any_of(layers_.begin(), layers_.end(), [&](const Layer& layer) {
      return any_pair(layer, patch, boxes_of_patch, budget, [&](Index i, Index t) {
        const Index f = layer.begin + i;
        return !is_in(f, out) && patch.meets(t, placed_triangle(mesh_, f)) && !may_meet(f);
      });
    });
  }

  /// how many pairs of faces, one of a patch and one of it or of the mesh, cross each other, but
  /// for parts of faces with the mesh, and what it takes the place of.
  std::size_t number_of_crossings(const Placed_patch& patch, const std::vector<Index>& out) const {
    std::size_t number = patch.number_of_crossings();
    const Placed_boxes boxes_of_patch = patch.placed_boxes();
    for(const Layer& layer : layers_)
      any_pair(layer, patch, boxes_of_patch, Pair_budget::unlimited(), [&](Index i, Index t) {
        const Index f = layer.begin + i;
        number += !patch.is_part(t) && !is_in(f, out) &&
                  are_crossing(patch.triangles()[t], placed_triangle(mesh_, f));
        return false;
      });
    return number;
  }

private:
  // Some faces that follow each other.
  struct Layer
  {
    Index begin, end;
    Placed_boxes boxes;
  };

  // Whether `f(i, t)` holds for a face of a layer and one of a patch, by their numbers there, of
  // those near each other. Where boxes say little of that, a closer look at all faces within the
  // box of the patch is less.
  template <typename Predicate>
  bool any_pair(const Layer& layer,
                const Placed_patch& patch,
                const Placed_boxes& boxes_of_patch,
                Pair_budget budget,
                const Predicate& f) const {
    const auto box = [&](Index i) { return this->box(layer.begin + i); };
    const auto box_of_patch = [&](Index t) { return patch.box(t); };
    std::optional<std::vector<Index>> faces;
    const auto is_over_or_holds = [&](Index i, Index t, std::size_t done) {
      if(budget.is_spent(done)) {
        if(faces)
          return true;
        faces = layer.boxes.meeting(patch.box(), box);
        budget.extend(faces->size());
      }
      return f(i, t);
    };
    const bool is_found =
        layer.boxes.any_meeting(boxes_of_patch, box, box_of_patch, is_over_or_holds);
    if(!budget.is_over())
      return is_found;
    if(const auto pairs = pairs_near(layer, *faces, patch))
      return std::any_of(pairs->begin(), pairs->end(),
                         [&](const auto& pair) { return f(pair.first, pair.second); });
    budget = Pair_budget::unlimited();
    return layer.boxes.any_meeting(boxes_of_patch, box, box_of_patch, is_over_or_holds);
  }

  std::optional<std::vector<std::pair<Index, Index>>>
  pairs_near(const Layer& layer, const std::vector<Index>& faces, const Placed_patch& patch) const {
    std::vector<Placed_triangle> triangles = patch.triangles();
    const Index number = static_cast<Index>(triangles.size());
    for(Index i : faces)
      triangles.push_back(placed_triangle(mesh_, layer.begin + i));
    auto pairs = near_pairs(std::move(triangles), number);
    if(pairs)
      for(auto& pair : *pairs)
        pair.first = faces[pair.first - number];
    return pairs;
  }

  // What is gone has no box, and caps are none of the surface.
  bool counts(Index f) const { return mesh_.is_alive(f) && !mesh_.is_in_cap(f); }

  Box<3> box(Index f) const {
    return counts(f) ? mesh_.box_axes().box(placed_triangle(mesh_, f).corners()) : Box<3>::empty();
  }

  Placed_boxes boxes(Execution execution, Index begin, Index end) const {
    return Placed_boxes(execution, end - begin, [this, begin](std::size_t i) {
      return box(begin + static_cast<Index>(i));
    });
  }

  const Surgery_mesh& mesh_;
  std::vector<Layer> layers_;
};

/// What some faces cross, which is found as it is asked for. Where a surface crosses itself, what
/// takes the place of a part of it cannot but cross what that has crossed.
class Former_contacts
{
public:
  /// of faces in ascending order.
  Former_contacts(const Surgery_mesh& mesh,
                  const Mesh_contacts& contacts,
                  const std::vector<Index>& faces)
      : mesh_(mesh)
      , contacts_(contacts)
      , faces_(faces)
      , placed_(mesh, patch_of(mesh, faces)) {}

  /// whether any two of the faces meet each other.
  bool are_own() { return !own().empty(); }

  /// whether one of the faces meets another one of them.
  bool are_of_own(Index face) { return is_in(face, own()); }

  /// whether any of the faces meets one of the surface that is not one of them.
  bool are_with(Index face) {
    if(are_too_many_)
      return false;
    const auto [answer, is_new] = answers_.insert(face, 0);
    if(is_new && meets(placed_triangle(mesh_, face))) {
      *answer = 1;
      met_.push_back(face);
      are_too_many_ = met_.size() > most();
    }
    return *answer != 0 && !are_too_many_;
  }

  /// whether the surface crosses itself all over here, so that there are no places to look for:
  /// then nothing counts as crossed. Near linear in the number of faces.
  bool are_too_many() {
    own();
    if(!are_others_counted_ && !are_too_many_)
      are_met_more_often(placed_, most());
    are_others_counted_ = true;
    return are_too_many_;
  }

  /// the same by a few of the faces: if they say so, it is taken for granted from then on.
  bool are_likely_too_many() {
    constexpr std::size_t few = 3;
    std::vector<Index> some;
    for(std::size_t i = 0; i < faces_.size(); i += faces_.size() / few + 1)
      some.push_back(faces_[i]);
    return are_met_more_often(Placed_patch(mesh_, patch_of(mesh_, some)),
                              most() * some.size() / faces_.size());
  }

  /// whether that is so and has been found. If it has not, all other answers are right.
  bool are_known_to_be_too_many() const { return are_too_many_; }

  /// faces of the surface because of which they are: for as long as all of them are there.
  std::vector<Index> met() const {
    std::vector<Index> faces = met_;
    make_set(faces);
    return faces;
  }

private:
  std::size_t most() const { return 1024 + 8 * faces_.size(); }

  // Whether some of the faces meet more than so many others, and then there are too many.
  bool are_met_more_often(const Placed_patch& some, std::size_t number) {
    std::vector<Index> met; // once for each of the faces that it meets
    are_too_many_ = contacts_.meets(
        some, faces_,
        [&](Index face) {
          met.push_back(face);
          return met.size() <= number;
        },
        Pair_budget::unlimited());
    if(are_too_many_)
      met_ = std::move(met);
    return are_too_many_;
  }

  // By boxes, which pays once there are several questions.
  bool meets(const Placed_triangle& face) {
    constexpr std::size_t few = 16;
    if(++number_of_questions_ <= few)
      return placed_.meets(face);
    if(!boxes_)
      boxes_ = placed_.placed_boxes();
    const std::vector<Index> close_ones = boxes_->meeting(
        mesh_.box_axes().box(face.corners()), [this](Index i) { return placed_.box(i); });
    return std::any_of(close_ones.begin(), close_ones.end(),
                       [&](Index i) { return placed_.meets(i, face); });
  }

  // None if there are too many.
  const std::vector<Index>& own() {
    if(!own_) {
      own_.emplace();
      const bool are_more = placed_.meets_itself(
          [&](Index i, Index j) {
            own_->insert(own_->end(), {faces_[i], faces_[j]});
            return own_->size() <= most();
          },
          Pair_budget::unlimited());
      if(are_more)
        own_->clear();
      are_too_many_ |= are_more;
      make_set(*own_);
    }
    return *own_;
  }

  const Surgery_mesh& mesh_;
  const Mesh_contacts& contacts_;
  const std::vector<Index>& faces_;
  const Placed_patch placed_;
  std::optional<std::vector<Index>> own_; // in ascending order, once they were asked for
  Index_table answers_;                   // by face, whether it is met
  std::vector<Index> met_;                // of these; or those that are too many
  std::size_t number_of_questions_ = 0;   // that these are to
  std::optional<Placed_boxes> boxes_;     // of the faces
  bool are_others_counted_ = false;
  bool are_too_many_ = false; // as far as that is known
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PATCH_H
