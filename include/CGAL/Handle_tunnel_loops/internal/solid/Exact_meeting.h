// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_EXACT_MEETING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_EXACT_MEETING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/assertions.h>

#include <array>

/// \file Exact_meeting.h
/// Whether segments and triangles meet, decided exactly. All are closed; a segment may be a point,
/// and a triangle a segment or a point.

namespace CGAL::Handle_tunnel_loops::internal {

using Exact_point = Exact_predicates_inexact_constructions_kernel::Point_3;
using Exact_segment = std::array<Exact_point, 2>;
using Exact_triangle = std::array<Exact_point, 3>;

inline Exact_point exact_point(const Vector& p) { return {p[0], p[1], p[2]}; }

/// whether a point of the line through a and b lies between them; either may be the point.
inline bool is_between(const Exact_point& p, const Exact_point& a, const Exact_point& b) {
  return (a <= p && p <= b) || (b <= p && p <= a);
}

inline bool is_on(const Exact_point& p, const Exact_segment& s) {
  return CGAL::collinear(s[0], p, s[1]) && is_between(p, s[0], s[1]);
}

/// whether two segments meet.
inline bool do_meet(const Exact_segment& s, const Exact_segment& t) {
  if(CGAL::orientation(s[0], s[1], t[0], t[1]) != COPLANAR)
    return false;
  if(is_on(s[0], t) || is_on(s[1], t) || is_on(t[0], s) || is_on(t[1], s))
    return true;
  // If they meet they cross: no three of the ends are on a line.
  const auto is_cut_by = [](const Exact_segment& u, const Exact_segment& v) {
    return !CGAL::collinear(u[0], u[1], v[0]) && !CGAL::collinear(u[0], u[1], v[1]) &&
           CGAL::coplanar_orientation(u[0], u[1], v[0], v[1]) == NEGATIVE;
  };
  return is_cut_by(s, t) && is_cut_by(t, s);
}

/// whether two segments that begin at the same point meet elsewhere, too. They have a length.
inline bool do_overlap(const Exact_point& begin, const Exact_point& a, const Exact_point& b) {
  CGAL_precondition(begin != a && begin != b);
  return CGAL::collinear(a, begin, b) &&
         !CGAL::collinear_are_strictly_ordered_along_line(a, begin, b);
}

/// whether a point of the plane of a triangle with an area lies in the angle at its first corner.
inline bool is_in_angle(const Exact_point& p, const Exact_triangle& t) {
  return CGAL::coplanar_orientation(t[0], t[1], t[2], p) != NEGATIVE &&
         CGAL::coplanar_orientation(t[0], t[2], t[1], p) != NEGATIVE;
}

/// whether a segment and a triangle in one plane meet.
inline bool do_meet_in_plane(const Exact_segment& s, const Exact_triangle& t) {
  for(int i = 0; i < 3; ++i)
    if(do_meet(s, Exact_segment{t[i], t[(i + 1) % 3]}))
      return true;
  if(CGAL::collinear(t[0], t[1], t[2]))
    return false;
  return is_in_angle(s[0], t) && is_in_angle(s[0], {t[1], t[2], t[0]});
}

/// whether a segment and a triangle meet.
inline bool do_meet(const Exact_segment& s, const Exact_triangle& t) {
  const auto side_0 = CGAL::orientation(t[0], t[1], t[2], s[0]);
  const auto side_1 = CGAL::orientation(t[0], t[1], t[2], s[1]);
  if(side_0 == side_1)
    return side_0 == COPLANAR && do_meet_in_plane(s, t);
  bool is_any_left = false, is_any_right = false;
  for(int i = 0; i < 3; ++i) {
    const auto side = CGAL::orientation(s[0], s[1], t[i], t[(i + 1) % 3]);
    is_any_left = is_any_left || side == POSITIVE;
    is_any_right = is_any_right || side == NEGATIVE;
  }
  return !(is_any_left && is_any_right);
}

/// whether a segment from the first corner of a triangle to another point meets it elsewhere, too.
inline bool do_meet_beyond_corner(const Exact_point& p, const Exact_triangle& t) {
  if(p == t[0] || CGAL::orientation(t[0], t[1], t[2], p) != COPLANAR)
    return false;
  for(int i = 1; i < 3; ++i)
    if(t[i] != t[0] && do_overlap(t[0], t[i], p))
      return true;
  return !CGAL::collinear(t[0], t[1], t[2]) && is_in_angle(p, t);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_EXACT_MEETING_H
