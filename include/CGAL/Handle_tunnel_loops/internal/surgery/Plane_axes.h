// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PLANE_AXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PLANE_AXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace CGAL::Handle_tunnel_loops::internal {

/// Axes at right angles to a vector of length 1, and to each other: how space is seen along it.
class Plane_axes
{
  using Kernel = Simple_cartesian<double>;

public:
  using Vector = Kernel::Vector_3;
  using Point = Kernel::Point_2;

  explicit Plane_axes(const Vector& normal)
      : x_(CGAL::cross_product(
            normal, std::abs(normal.x()) < 0.6 ? Vector(1., 0., 0.) : Vector(0., 1., 0.))) {
    x_ = x_ / std::sqrt(x_.squared_length());
    y_ = CGAL::cross_product(normal, x_);
  }

  Point seen(const Vector& v) const { return {v * x_, v * y_}; }
  Vector in_space(const Point& p) const { return p.x() * x_ + p.y() * y_; }

private:
  Vector x_, y_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PLANE_AXES_H
