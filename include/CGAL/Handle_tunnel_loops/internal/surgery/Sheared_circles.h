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

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_predicate.h>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Traits of triangulations of a plane that are Delaunay once it is sheared a little, so that points of
a symmetric polygon are on no circle: which of two Delaunay triangulations is found depends on
memory. Nothing is rounded by that.
*/
struct Sheared_circles : Exact_predicates_inexact_constructions_kernel
{
private:
  template <typename Kernel> struct Side_of_circle
  {
    using result_type = typename Kernel::Oriented_side;
    using Point = typename Kernel::Point_2;

    result_type operator()(const Point& p, const Point& q, const Point& r, const Point& t) const {
      return Kernel().side_of_oriented_circle_2_object()(sheared(p), sheared(q), sheared(r),
                                                         sheared(t));
    }

  private:
    static Point sheared(const Point& p) {
      using Number = typename Kernel::FT;
      return {p.x() + Number(1.3e-3) * p.y(), Number(1.0007) * p.y()};
    }
  };

public:
  using Side_of_oriented_circle_2 = Filtered_predicate<Side_of_circle<Exact_kernel>,
                                                       Side_of_circle<Approximate_kernel>,
                                                       C2E,
                                                       C2F>;

  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHEARED_CIRCLES_H
