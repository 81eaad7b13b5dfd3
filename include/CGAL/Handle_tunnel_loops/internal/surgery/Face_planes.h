// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_FACE_PLANES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_FACE_PLANES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The planes of triangles, which tell most that lie in layers apart at half the cost of exact
/// predicates: 32 bytes for each triangle.
class Face_planes
{
public:
  /// `triangle(i)` is the i-th of n, which have areas.
  template <typename Triangle_of>
  Face_planes(Execution execution, std::size_t n, const Triangle_of& triangle)
      : planes_(n) {
    for_each_index(execution, n, [&](std::size_t i) { planes_[i] = plane_of(triangle(i)); });
  }

  /// whether a triangle is surely on one side of the plane of number i.
  bool is_beside(const Placed_triangle& t, std::size_t i) const {
    const Plane& plane = planes_[i];
    const Heights h = heights(plane.normal, t);
    return h.low > plane.high + h.error || h.high < plane.low - h.error;
  }

private:
  // Rounded: any direction tells two triangles apart that do not overlap in it.
  using Normal = std::array<float, 3>;

  struct Plane
  {
    Normal normal;
    double low, high; // of the triangle, along the normal, and no less
  };

  struct Heights
  {
    double low, high, error;
  };

  static Heights heights(const Normal& n, const Placed_triangle& t) {
    std::array<double, 3> h;
    double largest = 0.;
    for(std::size_t i = 0; i < 3; ++i) {
      const auto& p = t.points[i];
      h[i] = n[0] * p.x() + n[1] * p.y() + n[2] * p.z();
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    }
    const bool overflows = !(largest < 0x1p1000);
    return {(std::min)({h[0], h[1], h[2]}), (std::max)({h[0], h[1], h[2]}),
            overflows ? HUGE_VAL : largest * 0x1p-49 + 0x1p-1060};
  }

  static Plane plane_of(const Placed_triangle& t) {
    const auto n = CGAL::cross_product(t.points[1] - t.points[0], t.points[2] - t.points[0]);
    const double largest = (std::max)({std::abs(n.x()), std::abs(n.y()), std::abs(n.z())});
    Plane plane;
    for(int i = 0; i < 3; ++i) // of what overflows no number, and nothing is beside it
      plane.normal[static_cast<std::size_t>(i)] = static_cast<float>(n[i] / largest);
    const Heights h = heights(plane.normal, t);
    plane.low = h.low - h.error;
    plane.high = h.high + h.error;
    return plane;
  }

  std::vector<Plane> planes_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_FACE_PLANES_H
