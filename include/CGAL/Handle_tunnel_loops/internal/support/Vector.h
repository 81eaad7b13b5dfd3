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

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

/// \file rounded_product.h
/// Products that are rounded before anything is added to them. Otherwise compilers may make
/// multiply-adds of both, which round once, and others, or the same for other processors, may not:
/// then arrival times would differ in the last bit, and with them loops. So would they if the
/// compiler were free to reorder sums: `-ffast-math` is not supported.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error                                                                                             \
    "Handle_tunnel_loops cannot be compiled with -ffast-math, -Ofast or -ffinite-math-only: it tests whether numbers are finite, and relies on the order of sums"
#endif

// The kind of register that floating-point numbers are in, for g++ and clang; on processors that
// are not named here the number goes through memory. Visual C++ makes no multiply-adds from 2022
// on unless told to (/fp:contract). Other compilers have to be told.
#if defined(__GNUC__) && defined(__SSE2_MATH__)
#define CGAL_HTL_FLOAT_REGISTER "+x"
#elif defined(__GNUC__) && defined(__aarch64__)
#define CGAL_HTL_FLOAT_REGISTER "+w"
#elif defined(__GNUC__)
#define CGAL_HTL_FLOAT_REGISTER "+m"
#endif

namespace CGAL::Handle_tunnel_loops::internal {

/// the same number, of which the compiler does not know where it is from. It costs nothing.
template <typename Float> Float opaque(Float number) {
#ifdef CGAL_HTL_FLOAT_REGISTER
  asm("" : CGAL_HTL_FLOAT_REGISTER(number));
#endif
  return number;
}

CGAL_HTL_HOST_DEVICE inline float rounded_product(float a, float b) {
#ifdef __CUDA_ARCH__
  return __fmul_rn(a, b);
#else
  return opaque(a * b);
#endif
}

CGAL_HTL_HOST_DEVICE inline double rounded_product(double a, double b) {
#ifdef __CUDA_ARCH__
  return __dmul_rn(a, b);
#else
  return opaque(a * b);
#endif
}

/// half the difference of numbers, which are halved first: that of the largest doubles overflows.
/// Half of the smallest ones is rounded.
inline double half_difference(double a, double b) {
  return rounded_product(0.5, a) - rounded_product(0.5, b);
}

/// the length of a vector, of products that are rounded.
CGAL_HTL_HOST_DEVICE inline double rounded_length(double x, double y, double z) {
  return std::sqrt(rounded_product(x, x) + rounded_product(y, y) + rounded_product(z, z));
}

/// the same of vectors so long, or so short, that the squares are no numbers any more.
inline double rounded_length_of_any(double x, double y, double z) {
  const double most = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  if(!(most > 0. && most <= (std::numeric_limits<double>::max)()))
    return most;
  const int e = std::ilogb(most);
  return std::ldexp(rounded_length(std::ldexp(x, -e), std::ldexp(y, -e), std::ldexp(z, -e)), e);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#undef CGAL_HTL_FLOAT_REGISTER

namespace CGAL::Handle_tunnel_loops::internal {

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

/// a vector of length 1, or the null vector.
inline Vector unit(const Vector& a) {
  const double length = norm(a);
  return length > 0. ? (1. / length) * a : Vector{0., 0., 0.};
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_VECTOR_H
