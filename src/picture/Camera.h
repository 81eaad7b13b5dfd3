// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_CAMERA_H
#define HTL_PICTURE_CAMERA_H

#include "picture.h"

#include <array>
#include <cmath>
#include <vector>

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

inline Vector_3 cross(Vector_3 a, Vector_3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// the product of each coordinate.
inline Vector_3 modulate(Vector_3 a, Vector_3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// the vector of length one, or the null vector.
inline Vector_3 normalized(Vector_3 a) {
  const float length = std::sqrt(dot(a, a));
  return length > 0.f ? (1.f / length) * a : Vector_3{};
}

/// A point of the picture: in pixels from the upper left corner, and the inverse of the distance
/// from the eye's plane, which is linear along lines of the picture.
struct Projected_point
{
  float x, y, inverse_depth;
};

/*!
A mild perspective view of what is in a set of points, at a size that fills a picture, or a part of
it.

The camera's frame has its origin in the middle of the points, x to the right, y upwards and z to
the eye; its unit is the largest distance of a point from the origin.
*/
class Camera
{
public:
  Camera(const std::vector<const std::vector<Point>*>& seen,
         const Point& view,
         const Point& up,
         int width,
         int height,
         double part = usual_part);

  static constexpr double usual_part = 0.92; ///< of the picture that is filled

  Vector_3 in_frame(const Point& p) const;
  float in_frame(double length) const { return static_cast<float>(length / unit_); }
  double in_space(float length) const { return double(length) * unit_; }
  Projected_point project(Vector_3 in_frame) const;

  /// the point in the camera's frame that is seen at a place of the picture.
  Vector_3 unproject(Projected_point p) const;

  /// the size of a pixel at a depth, in the unit of the frame.
  float pixel_size(float inverse_depth) const { return 1.f / (scale_ * inverse_depth); }

  /// the size of a pixel at the origin of the frame.
  float pixel_size_in_middle() const { return pixel_size(project({}).inverse_depth); }

private:
  void choose_unit(const std::vector<const std::vector<Point>*>& seen);
  void fill_picture(const std::vector<const std::vector<Point>*>& seen,
                    int width,
                    int height,
                    double part);

  std::array<Point, 3> axes_;
  Point centre_ = {0., 0., 0.};
  double unit_ = 1.;
  // A place in the picture is scale_ * (x / depth, -y / depth) + shift.
  float scale_ = 1.f, shift_x_ = 0.f, shift_y_ = 0.f;
};

} // namespace htl_picture

#endif // HTL_PICTURE_CAMERA_H
