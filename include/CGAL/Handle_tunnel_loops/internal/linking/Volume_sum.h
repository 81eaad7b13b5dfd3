// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_VOLUME_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_VOLUME_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

using Triangle = std::array<Vector, 3>;

/// Six times the volume between faces and their projections to a plane, and how far it may be off.
class Volume_sum
{
public:
  /// \p plane is a height, the same for all that is added.
  void add(const Triangle& t, double plane) {
    const Vector a = t[1] - t[0], b = t[2] - t[0];
    const double left = a[0] * b[1], right = a[1] * b[0];
    const double z[3] = {t[0][2] - plane, t[1][2] - plane, t[2][2] - plane};
    value_ += (left - right) * (z[0] + z[1] + z[2]);
    magnitude_ +=
        (std::abs(left) + std::abs(right)) * (std::abs(z[0]) + std::abs(z[1]) + std::abs(z[2]));
    ++terms_;
  }

  /// adds what the faces at a vertex, with these neighbours, have by the height of this corner;
  /// summed over all vertices, it is the same.
  template <typename Neighbors, typename Place_of_vertex>
  void add_star(Index v, const Neighbors& around, const Place_of_vertex& place, double plane) {
    const Vector corner = place(v);
    const double z = corner[2] - plane;
    Vector a = place(around[around.size() - 1]) - corner;
    double area = 0., size = 0.;
    for(const Index u : around) {
      const Vector b = place(u) - corner;
      const double left = a[0] * b[1], right = a[1] * b[0];
      area += left - right;
      size += std::abs(left) + std::abs(right);
      a = b;
    }
    value_ += area * z;
    magnitude_ += size * std::abs(z);
    terms_ += around.size();
  }

  void add(const Volume_sum& v, std::size_t) {
    terms_ += v.terms_;
    value_ += v.value_;
    magnitude_ += v.magnitude_;
  }

  /// the sign of the volume that closed surfaces enclose, or 0 if rounding may decide it.
  int sign() const {
    // Each term is off by a few roundings, each sum by one; nothing is known of what underflows.
    const double error = magnitude_ * (8. * double(terms_) + 16.) * 0x1p-53;
    if(!(std::abs(value_) > error && std::abs(value_) > 1e-250))
      return 0;
    return value_ > 0. ? 1 : -1;
  }

private:
  std::size_t terms_ = 0;
  double value_ = 0., magnitude_ = 0.; // of the sum, and of the absolute values of its terms
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_VOLUME_SUM_H
