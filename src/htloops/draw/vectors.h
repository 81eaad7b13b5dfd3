// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VECTORS_H
#define HTLOOPS_VECTORS_H

#include <array>
#include <cmath>

namespace htloops {

using Vector = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// the vector of length one, or the null vector.
inline Vector unit(const Vector& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  return length > 0. ? Vector{a[0] / length, a[1] / length, a[2] / length} : Vector{};
}

} // namespace htloops

#endif // HTLOOPS_VECTORS_H
