// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_VECTOR_3_H
#define HTL_PICTURE_VECTOR_3_H

#include <array>
#include <cmath>

namespace htl_picture {

/// A vector in space, or a colour in linear light. Single precision is enough: everything is moved
/// into the unit sphere first.
struct Vector_3
{
  float x = 0.f, y = 0.f, z = 0.f;
};

inline Vector_3 operator+(Vector_3 a, Vector_3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector_3 operator-(Vector_3 a, Vector_3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector_3 operator*(float s, Vector_3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(Vector_3 a, Vector_3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// the product of each coordinate.
inline Vector_3 modulate(Vector_3 a, Vector_3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

inline Vector_3 cross(Vector_3 a, Vector_3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// the vector of length one, or the null vector.
inline Vector_3 normalized(Vector_3 a) {
  const float length = std::sqrt(dot(a, a));
  return length > 0.f ? (1.f / length) * a : Vector_3{};
}

} // namespace htl_picture

#endif // HTL_PICTURE_VECTOR_3_H
