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
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Placed_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/assertions.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

inline Box<3> box_at(const Surgery_mesh::Point& p) {
  return {{p.x(), p.y(), p.z()}, {p.x(), p.y(), p.z()}};
}

/// A triangle by its corners: the numbers tell which corners two triangles share.
struct Placed_triangle
{
  using Kernel = Surgery_mesh::Kernel;

  std::array<Index, 3> vertices;
  std::array<Kernel::Point_3, 3> points;

  bool is_degenerate() const { return CGAL::collinear(points[0], points[1], points[2]); }
  Kernel::Triangle_3 triangle() const { return {points[0], points[1], points[2]}; }
  double area() const { return std::sqrt(triangle().squared_area()); }
  Box<3> box() const {
    Box<3> box = box_at(points[0]);
    box.extend(box_at(points[1]));
    box.extend(box_at(points[2]));
    return box;
  }
};

inline Placed_triangle placed_triangle(const Surgery_mesh& mesh, Index face) {
  const Surgery_mesh::Face& v = mesh.corners(face);
  return {v, {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])}};
}

/// Whether two triangles of a mesh meet elsewhere than in the vertices and the edge that they
/// share; by exact predicates (as for `Polygon_mesh_processing::self_intersections()`).
class Triangle_contact
{
  using Kernel = Surgery_mesh::Kernel;
  using Segment = Kernel::Segment_3;

public:
  Triangle_contact(const Placed_triangle& a, const Placed_triangle& b)
      : a_(a)
      , b_(b) {
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        if(a.vertices[i] == b.vertices[j]) {
          shared_in_a_[number_shared_] = i;
          shared_in_b_[number_shared_++] = j;
        }
  }

  bool operator()() const {
    if(are_surely_apart())
      return false;
    if(b_.is_degenerate())
      return meets_degenerate();
    if(a_.is_degenerate())
      return Triangle_contact(b_, a_)();
    switch(number_shared_) {
    case 0:
      return CGAL::do_intersect(a_.triangle(), b_.triangle());
    case 1:
      return CGAL::do_intersect(opposite_side(a_, shared_in_a_[0]), b_.triangle()) ||
             CGAL::do_intersect(opposite_side(b_, shared_in_b_[0]), a_.triangle());
    case 2:
      return overlap_at_edge();
    default:
      return true;
    }
  }

private:
  using Corners = std::array<std::size_t, 9>; // nine: for faces without area

  // What most are. Orientations are the fastest predicates, and a triangle without area has none.
  bool are_surely_apart() const {
    if(number_shared_ == 2) // an edge, unless a corner counts twice
      return shared_in_a_[0] != shared_in_a_[1] && shared_in_b_[0] != shared_in_b_[1] &&
             are_bent_at_edge();
    return number_shared_ < 2 &&
           (is_beside(b_, shared_in_b_, a_) || is_beside(a_, shared_in_a_, b_));
  }

  // Whether all corners of a triangle but the shared one are on the same side of the plane of
  // another one.
  bool
  is_beside(const Placed_triangle& t, const Corners& shared, const Placed_triangle& other) const {
    Orientation side = COPLANAR;
    for(std::size_t i = 0; i < 3; ++i) {
      if(number_shared_ == 1 && i == shared[0])
        continue;
      const Orientation o =
          CGAL::orientation(other.points[0], other.points[1], other.points[2], t.points[i]);
      if(o == COPLANAR || (side != COPLANAR && o != side))
        return false;
      side = o;
    }
    return true;
  }

  static Segment opposite_side(const Placed_triangle& t, std::size_t corner) {
    return {t.points[(corner + 1) % 3], t.points[(corner + 2) % 3]};
  }

  const Kernel::Point_3& apex_of_a() const {
    return a_.points[3 - shared_in_a_[0] - shared_in_a_[1]];
  }
  const Kernel::Point_3& apex_of_b() const {
    return b_.points[3 - shared_in_b_[0] - shared_in_b_[1]];
  }

  bool are_bent_at_edge() const {
    return CGAL::orientation(a_.points[shared_in_a_[0]], a_.points[shared_in_a_[1]], apex_of_a(),
                             apex_of_b()) != COPLANAR;
  }

  // In a plane.
  bool overlap_at_edge() const {
    return CGAL::coplanar_orientation(a_.points[shared_in_a_[0]], a_.points[shared_in_a_[1]],
                                      apex_of_a(), apex_of_b()) == POSITIVE;
  }

  // A triangle without area is the union of its sides. Those at a corner that is shared are left
  // out: they begin on the other triangle. Two without area are not said to meet.
  bool meets_degenerate() const {
    if(a_.is_degenerate())
      return false;
    for(std::size_t i = 0; i < 3; ++i) {
      const bool is_shared = is_shared_in_b((i + 1) % 3) || is_shared_in_b((i + 2) % 3);
      const Segment side = opposite_side(b_, i);
      if(!is_shared && (side.is_degenerate() ? a_.triangle().has_on(side.source())
                                             : CGAL::do_intersect(side, a_.triangle())))
        return true;
    }
    return false;
  }

  bool is_shared_in_b(std::size_t corner) const {
    return std::find(shared_in_b_.begin(), shared_in_b_.begin() + number_shared_, corner) !=
           shared_in_b_.begin() + number_shared_;
  }

  const Placed_triangle &a_, &b_;
  Corners shared_in_a_, shared_in_b_;
  std::size_t number_shared_ = 0;
};

inline bool are_in_contact(const Placed_triangle& a, const Placed_triangle& b) {
  return Triangle_contact(a, b)();
}

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
  Placed_patch(const Surgery_mesh& mesh, const Patch& patch, Index first = 0) {
    for(std::size_t i = 0; i < patch.faces.size(); ++i) {
      triangles_.push_back(patch.placed(mesh, i));
      for(Index& v : triangles_.back().vertices)
        if(v >= Patch::first_own)
          v += first;
      boxes_.push_back(triangles_.back().box());
      box_.extend(boxes_.back());
    }
    for(Index f : patch.parents)
      parents_.push_back(placed_triangle(mesh, f));
  }

  const std::vector<Placed_triangle>& triangles() const { return triangles_; }

  const Box<3>& box(std::size_t i) const { return boxes_[i]; }

  /// of all.
  const Box<3>& box() const { return box_; }

  /// those that are parts of faces of the mesh come first.
  std::size_t number_of_parts() const { return parents_.size(); }

  /// whether one of the triangles meets a face that is not of the patch, and did not before.
  bool meets(std::size_t i, const Placed_triangle& face) const {
    return are_in_contact(triangles_[i], face) &&
           !(is_part(i) && are_in_contact(parents_[i], face));
  }

  bool meets(const Placed_patch& other) const {
    if(!box_.meets(other.box_))
      return false;
    return placed_boxes().any_meeting(
        other.placed_boxes(), [this](Index i) { return boxes_[i]; },
        [&](Index j) { return other.boxes_[j]; },
        [&](Index i, Index j) {
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
  /// `may_meet(i, j)`.
  template <typename Predicate> bool meets_itself(const Predicate& may_meet) const {
    const Placed_boxes near = placed_boxes();
    const auto box = [this](Index i) { return boxes_[i]; };
    // Parts come first, and do not meet each other.
    return near.any_meeting(near, box, box, [&](Index i, Index j) {
      return i > j && !is_part(i) && are_in_contact(triangles_[i], triangles_[j]) &&
             !may_meet(i, j);
    });
  }

  /// whether a triangle is part of a face of the mesh.
  bool is_part(std::size_t i) const { return i < parents_.size(); }

  Placed_boxes placed_boxes() const {
    return Placed_boxes(Execution(), boxes_.size(), [this](std::size_t i) { return boxes_[i]; });
  }

private:
  std::vector<Placed_triangle> triangles_, parents_;
  std::vector<Box<3>> boxes_; // of the triangles
  Box<3> box_ = Box<3>::empty();
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
  /// those that `may_meet(f)`. Near linear in the size of the patch.
  template <typename Predicate>
  bool
  meets(const Placed_patch& patch, const std::vector<Index>& out, const Predicate& may_meet) const {
    CGAL_precondition(!layers_.empty() && layers_.back().end == mesh_.face_bound());
    const Placed_boxes boxes_of_patch = patch.placed_boxes();
    return std::any_of(layers_.begin(), layers_.end(), [&](const Layer& layer) {
      return layer.boxes.any_meeting(
          boxes_of_patch, [&](Index i) { return box(layer.begin + i); },
          [&](Index t) { return patch.box(t); },
          [&](Index i, Index t) {
            const Index f = layer.begin + i;
            return !is_in(f, out) && patch.meets(t, placed_triangle(mesh_, f)) && !may_meet(f);
          });
    });
  }

private:
  // Some faces that follow each other.
  struct Layer
  {
    Index begin, end;
    Placed_boxes boxes;
  };

  // What is gone has no box, and caps are none of the surface.
  bool counts(Index f) const { return mesh_.is_alive(f) && !mesh_.is_in_cap(f); }

  Box<3> box(Index f) const {
    return counts(f) ? placed_triangle(mesh_, f).box() : Box<3>::empty();
  }

  Placed_boxes boxes(Execution execution, Index begin, Index end) const {
    return Placed_boxes(execution, end - begin, [this, begin](std::size_t i) {
      return box(begin + static_cast<Index>(i));
    });
  }

  const Surgery_mesh& mesh_;
  std::vector<Layer> layers_;
};

/// What some faces cross. Where a surface crosses itself, what takes the place of a part of it
/// cannot but cross what that has crossed. Where it does so all over, nothing is said to be
/// crossed: there are no places to look for.
class Former_contacts
{
public:
  /// of faces in ascending order. Near linear in their number.
  Former_contacts(const Surgery_mesh& mesh,
                  const Mesh_contacts& contacts,
                  const std::vector<Index>& faces) {
    Patch patch;
    for(Index f : faces)
      patch.faces.push_back(mesh.corners(f));
    const Placed_patch placed(mesh, patch);
    const std::size_t most = 1024 + 8 * faces.size();
    const bool are_too_many = placed.meets_itself([&](Index i, Index j) {
      own_.insert(own_.end(), {faces[i], faces[j]});
      return own_.size() <= most;
    }) || contacts.meets(placed, faces, [&](Index f) {
      others_.push_back(f);
      return others_.size() <= most;
    });
    if(are_too_many) {
      own_.clear();
      others_.clear();
    }
    make_set(own_);
    make_set(others_);
  }

  bool are_none() const { return own_.empty() && others_.empty(); }

  /// whether any two of the faces meet each other.
  bool are_own() const { return !own_.empty(); }

  /// whether one of the faces meets another one of them.
  bool are_of_own(Index face) const { return is_in(face, own_); }

  /// whether any of the faces meets one that is not one of them.
  bool are_with(Index face) const { return is_in(face, others_); }

private:
  std::vector<Index> own_, others_; // in ascending order
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PATCH_H
