// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHEARED_CIRCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHEARED_CIRCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Traits of triangulations of a plane that are Delaunay once it is sheared a little, so that points of
a symmetric polygon are on no circle: which of two Delaunay triangulations is found depends on
memory. Nothing is rounded by that.
*/
struct Sheared_circles : Exact_predicates_inexact_constructions_kernel
{
  struct Side_of_oriented_circle_2
  {
    Oriented_side
    operator()(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& t) const {
      return CGAL::side_of_oriented_circle(sheared(p), sheared(q), sheared(r), sheared(t));
    }

  private:
    using Exact = Exact_predicates_exact_constructions_kernel;

    static Exact::Point_2 sheared(const Point_2& p) {
      const Exact::FT x = p.x(), y = p.y();
      return {x + 1.3e-3 * y, 1.0007 * y};
    }
  };

  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHEARED_CIRCLES_H
