// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_ANGLE_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_ANGLE_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Handle_tunnel_loops::internal {

/// Adds up angles between 0 and a straight one, without trigonometric functions.
class Angle_sum
{
public:
  /// adds the angle whose cosine and sine are in the ratio of the arguments. Returns whether the
  /// sum is still less than straight.
  bool add(double cosine, double sine) {
    const double c = rounded_product(cosine_, cosine) - rounded_product(sine_, sine);
    const double s = rounded_product(cosine_, sine) + rounded_product(sine_, cosine);
    const double size = (std::max)(std::abs(c), std::abs(s));
    cosine_ = size > 0. ? c / size : 1.;
    sine_ = size > 0. ? s / size : 0.;
    constexpr double tolerance = 1e-7;
    return sine_ > tolerance || (sine_ >= 0. && cosine_ > 0.);
  }

private:
  double cosine_ = 1., sine_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_ANGLE_SUM_H
