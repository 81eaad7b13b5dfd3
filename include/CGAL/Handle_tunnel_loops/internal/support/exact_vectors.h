// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_EXACT_VECTORS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_EXACT_VECTORS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/Exact_rational.h>

#include <array>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

using Exact_vector = std::array<Exact_rational, 3>;

inline Exact_vector exact(const Vector& a) {
  return {Exact_rational(a[0]), Exact_rational(a[1]), Exact_rational(a[2])};
}
inline Exact_vector operator+(const Exact_vector& a, const Exact_vector& b) {
  return {Exact_rational(a[0] + b[0]), Exact_rational(a[1] + b[1]), Exact_rational(a[2] + b[2])};
}
inline Exact_vector operator-(const Exact_vector& a, const Exact_vector& b) {
  return {Exact_rational(a[0] - b[0]), Exact_rational(a[1] - b[1]), Exact_rational(a[2] - b[2])};
}
inline Exact_vector operator*(const Exact_rational& s, const Exact_vector& a) {
  return {Exact_rational(s * a[0]), Exact_rational(s * a[1]), Exact_rational(s * a[2])};
}
inline Exact_rational dot(const Exact_vector& a, const Exact_vector& b) {
  return Exact_rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
inline Exact_vector cross(const Exact_vector& a, const Exact_vector& b) {
  return {Exact_rational(a[1] * b[2] - a[2] * b[1]), Exact_rational(a[2] * b[0] - a[0] * b[2]),
          Exact_rational(a[0] * b[1] - a[1] * b[0])};
}
inline bool is_zero(const Exact_vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

inline int sign_of(const Exact_rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_EXACT_VECTORS_H
