// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SAMPLES_H
#define HTLOOPS_SAMPLES_H

#include "draw/surfaces.h"
#include "scene/scene.h"

#include <CGAL/Bbox_3.h>

#include <vector>

namespace htloops {

/// of a triangle, as long as twice its area.
inline Vector normal_of(const Vector& a, const Vector& b, const Vector& c) {
  return cross(minus(b, a), minus(c, a));
}

/// Moves what is at some points into the unit ball, the middle of their box into its own.
class Ball_around
{
public:
  explicit Ball_around(const std::vector<Vector>& points);

  Vector operator()(const Vector& p) const;
  std::vector<Vector> moved(const std::vector<Vector>& points) const;

private:
  Vector in_cube(const Vector& p) const;

  CGAL::Bbox_3 box_;
  double half_ = 0., radius_ = 1.;
};

/// about so many points of a surface that stand for equal parts of it, however large its triangles
/// are.
std::vector<Vector> samples_of(const std::vector<Vector>& points,
                               const std::vector<htl_scene::Triangle>& triangles,
                               double count);

} // namespace htloops

#endif // HTLOOPS_SAMPLES_H
