// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ARE_COLLINEAR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ARE_COLLINEAR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <cmath>

namespace CGAL::Handle_tunnel_loops::internal {

/// whether three points lie on a line.
bool are_exactly_collinear(const Vector& a, const Vector& b, const Vector& c);

/// the same: decided in floating point where that is beyond doubt.
inline bool are_collinear(const Vector& a, const Vector& b, const Vector& c) {
  const Vector u = b - a, v = c - a;
  for(int d = 0; d < 3; ++d) {
    const int e = (d + 1) % 3;
    const double left = u[d] * v[e], right = u[e] * v[d];
    // Also false where a product overflows. Below 1e-290 products may have lost their digits.
    if(std::abs(left - right) > 1e-14 * (std::abs(left) + std::abs(right)) + 1e-290)
      return false;
  }
  return are_exactly_collinear(a, b, c);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ARE_COLLINEAR_H
