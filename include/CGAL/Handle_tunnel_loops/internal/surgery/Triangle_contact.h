// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLE_CONTACT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLE_CONTACT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/triangles_apart.h>

#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::Handle_tunnel_loops::internal {

inline Box<3> box_at(const Surgery_mesh::Point& p) {
  return {Surgery_mesh::place_of(p), Surgery_mesh::place_of(p)};
}

/// A triangle by its corners: the numbers tell which corners two triangles share.
struct Placed_triangle
{
  using Kernel = Surgery_mesh::Kernel;

  std::array<Index, 3> vertices;
  std::array<Kernel::Point_3, 3> points;

  bool is_degenerate() const { return CGAL::collinear(points[0], points[1], points[2]); }
  Corner_points corners() const {
    const auto place = [](const Kernel::Point_3& p) { return Surgery_mesh::place_of(p); };
    return {place(points[0]), place(points[1]), place(points[2])};
  }
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
    if(number_shared_ > 2)
      return false;
    if(number_shared_ == 0 && are_seen_apart(a_.corners(), b_.corners()))
      return true;
    const Position position = position_of(b_, shared_in_b_, a_);
    if(position == IN_PLANE)
      return are_apart_in_plane();
    return position == BESIDE || position_of(a_, shared_in_a_, b_) == BESIDE;
  }

  enum Position { BESIDE, ACROSS, IN_PLANE };

  // Where all corners of a triangle but the shared one are to the plane of another one: on the same
  // side of it, or in it.
  Position
  position_of(const Placed_triangle& t, const Corners& shared, const Placed_triangle& other) const {
    std::optional<Orientation> side;
    for(std::size_t i = 0; i < 3; ++i) {
      if(is_the_shared(i, shared))
        continue;
      const Orientation o =
          CGAL::orientation(other.points[0], other.points[1], other.points[2], t.points[i]);
      if(side && o != *side)
        return ACROSS;
      side = o;
    }
    return *side == COPLANAR ? IN_PLANE : BESIDE;
  }

  bool is_the_shared(std::size_t i, const Corners& shared) const {
    return number_shared_ == 1 && i == shared[0];
  }

  using Flat_corners = std::array<Kernel::Point_2, 3>;

  // Whether a side of one triangle has the other one beyond it, as seen along an axis that is not
  // in the plane of both.
  bool are_apart_in_plane() const {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const Flat_corners a = seen_along(axis, a_), b = seen_along(axis, b_);
      if(CGAL::orientation(a[0], a[1], a[2]) != COLLINEAR)
        return is_beyond_side(b, shared_in_b_, a, shared_in_a_) ||
               is_beyond_side(a, shared_in_a_, b, shared_in_b_);
    }
    return false;
  }

  static Flat_corners seen_along(std::size_t axis, const Placed_triangle& t) {
    const int x = static_cast<int>((axis + 1) % 3), y = static_cast<int>((axis + 2) % 3);
    Flat_corners corners;
    for(std::size_t i = 0; i < 3; ++i)
      corners[i] = {t.points[i][x], t.points[i][y]};
    return corners;
  }

  // The corner that is shared may be on the side.
  bool is_beyond_side(const Flat_corners& t,
                      const Corners& shared,
                      const Flat_corners& other,
                      const Corners& shared_in_other) const {
    const Orientation inner = CGAL::orientation(other[0], other[1], other[2]);
    for(std::size_t k = 0; inner != COLLINEAR && k < 3; ++k) {
      bool is_beyond = !is_the_shared((k + 2) % 3, shared_in_other);
      for(std::size_t i = 0; is_beyond && i < 3; ++i)
        is_beyond = is_the_shared(i, shared) ||
                    CGAL::orientation(other[k], other[(k + 1) % 3], t[i]) == -inner;
      if(is_beyond)
        return true;
    }
    return false;
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

/// whether two triangles meet elsewhere than in corners and edges at the same places, as where a
/// surface that was no manifold has been split.
inline bool are_crossing(const Placed_triangle& a, Placed_triangle b) {
  if(!are_in_contact(a, b))
    return false;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      if(a.points[i] == b.points[j])
        b.vertices[j] = a.vertices[i];
  return are_in_contact(a, b);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGLE_CONTACT_H
