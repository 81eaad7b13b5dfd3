// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_VECTOR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_VECTOR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/rounded_product.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

using Vector = std::array<double, 3>;

inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator*(double s, const Vector& a) {
  return {rounded_product(s, a[0]), rounded_product(s, a[1]), rounded_product(s, a[2])};
}
inline double dot(const Vector& a, const Vector& b) {
  return rounded_product(a[0], b[0]) + rounded_product(a[1], b[1]) + rounded_product(a[2], b[2]);
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {rounded_product(a[1], b[2]) - rounded_product(a[2], b[1]),
          rounded_product(a[2], b[0]) - rounded_product(a[0], b[2]),
          rounded_product(a[0], b[1]) - rounded_product(a[1], b[0])};
}
inline double norm(const Vector& a) { return std::sqrt(dot(a, a)); }

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_VECTOR_H
