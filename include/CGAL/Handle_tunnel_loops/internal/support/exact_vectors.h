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
#ifdef CGAL_USE_GMP
#include <CGAL/Mpzf.h>
#endif

#include <array>

namespace CGAL::Handle_tunnel_loops::internal {

/// Sums and products of doubles. Without common divisors to be looked for it is some times as fast
/// as a rational number.
#ifdef CGAL_HAS_MPZF
using Exact_number = Mpzf;
#else
using Exact_number = Exact_rational;
#endif

template <typename Number> using Vector_of_numbers = std::array<Number, 3>;
using Exact_vector = Vector_of_numbers<Exact_number>;

inline Exact_vector exact(const Vector& a) {
  return {Exact_number(a[0]), Exact_number(a[1]), Exact_number(a[2])};
}
template <typename N>
Vector_of_numbers<N> operator+(const Vector_of_numbers<N>& a, const Vector_of_numbers<N>& b) {
  return {N(a[0] + b[0]), N(a[1] + b[1]), N(a[2] + b[2])};
}
template <typename N>
Vector_of_numbers<N> operator-(const Vector_of_numbers<N>& a, const Vector_of_numbers<N>& b) {
  return {N(a[0] - b[0]), N(a[1] - b[1]), N(a[2] - b[2])};
}
template <typename N> N dot(const Vector_of_numbers<N>& a, const Vector_of_numbers<N>& b) {
  return N(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}
template <typename N>
Vector_of_numbers<N> cross(const Vector_of_numbers<N>& a, const Vector_of_numbers<N>& b) {
  return {N(a[1] * b[2] - a[2] * b[1]), N(a[2] * b[0] - a[0] * b[2]), N(a[0] * b[1] - a[1] * b[0])};
}

template <typename N> int sign_of(const N& x) { return x > N(0) ? 1 : x < N(0) ? -1 : 0; }

template <typename N> bool is_zero(const Vector_of_numbers<N>& a) {
  return sign_of(a[0]) == 0 && sign_of(a[1]) == 0 && sign_of(a[2]) == 0;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_EXACT_VECTORS_H
