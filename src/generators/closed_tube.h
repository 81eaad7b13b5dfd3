// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CLOSED_TUBE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CLOSED_TUBE_H

#include "Field.h"
#include "generators.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A closed curve, by arc length.
class Curve_by_length
{
public:
  /// a curve as a function on [0, 2 pi].
  explicit Curve_by_length(std::function<Vector(double)> curve);

  double length() const { return length_.back(); }
  Vector point(double s) const;

private:
  static constexpr int samples = 10000;
  static double parameter(double i);

  std::function<Vector(double)> curve_;
  std::vector<double> length_ = std::vector<double>(samples + 1, 0.);
};

/// a round tube of about a number of faces around a closed curve. It does not cross itself if the
/// curve keeps away from itself and the faces are enough to follow it.
Soup closed_tube(const Curve_by_length& curve, double radius, std::size_t faces);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_CLOSED_TUBE_H
