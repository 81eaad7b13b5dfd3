// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_COLLAR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_COLLAR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Polygon_in_space.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
A narrow band that stands on the faces along a polygon on a surface, at right angles as far as that
can be. At its other side is a polygon with fewer corners: where those on the surface are closer to
each other than the band is high, they share one. So the bumps of a surface are left behind, and a
membrane that begins at the band does not lean on them.
*/
class Collar
{
public:
  using Triangle =
      std::array<std::size_t, 3>; ///< corners of the polygon, and then of the inner one

  /// \p polygon has normals, and says on which side the band is.
  Collar(const Polygon_in_space& polygon, double height)
      : polygon_(polygon)
      , side_(polygon.at_sides == Polygon_in_space::OUTSIDE ? 1. : -1.)
      , height_(height) {
    find_groups();
    if(starts_.size() < 3)
      return;
    for(std::size_t k = 0; k < starts_.size(); ++k)
      inner_.points.push_back(point_above(k));
    join();
  }

  /// whether there is one: it may be too high for a small polygon.
  bool is_good() const { return inner_.size() >= 3; }

  const std::vector<Triangle>& triangles() const { return triangles_; }

  /// what is left to be filled.
  const Polygon_in_space& inner() const { return inner_; }

private:
  using Vector = Simple_cartesian<double>::Vector_3;

  std::size_t size() const { return polygon_.size(); }
  std::size_t after(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }

  Vector step(std::size_t i) const {
    const auto &p = polygon_.points[i], &q = polygon_.points[after(i)];
    return {q.x() - p.x(), q.y() - p.y(), q.z() - p.z()};
  }

  static Vector normalized(const Vector& v) {
    const double length = std::sqrt(v.squared_length());
    return length > 0. ? v / length : v;
  }

  // The first corners of what shares a corner of the inner polygon. The longest side is between
  // two groups.
  void find_groups() {
    std::size_t longest = 0;
    for(std::size_t i = 0; i < size(); ++i)
      if(step(i).squared_length() > step(longest).squared_length())
        longest = i;
    double length = 0.;
    for(std::size_t n = 0, i = after(longest); n < size(); ++n, i = after(i)) {
      if(n == 0 || length > height_) {
        starts_.push_back(i);
        length = 0.;
      }
      length += std::sqrt(step(i).squared_length());
    }
  }

  std::size_t end(std::size_t group) const {
    return starts_[group + 1 == starts_.size() ? 0 : group + 1];
  }

  // At right angles to both faces at a corner, as far as that can be.
  Vector direction(std::size_t i) const {
    const Vector m = normalized(polygon_.normals_beyond[before(i)]),
                 n = normalized(polygon_.normals_beyond[i]), up = normalized(m + n),
                 across = normalized(CGAL::cross_product(m, normalized(step(before(i)))) +
                                     CGAL::cross_product(n, normalized(step(i))));
    return side_ * normalized(up - (up * across) * across);
  }

  Surgery_mesh::Point point_above(std::size_t group) const {
    double number = 0.;
    Vector sum(NULL_VECTOR);
    std::size_t i = starts_[group];
    const auto& origin = polygon_.points[i];
    do {
      const auto& p = polygon_.points[i];
      sum = sum + Vector(p.x() - origin.x(), p.y() - origin.y(), p.z() - origin.z()) +
            height_ * direction(i);
      number += 1.;
      i = after(i);
    } while(i != end(group));
    sum = sum / number;
    return {origin.x() + sum.x(), origin.y() + sum.y(), origin.z() + sum.z()};
  }

  void join() {
    for(std::size_t k = 0; k < starts_.size(); ++k) {
      const std::size_t inner = size() + k, next = size() + (k + 1 == starts_.size() ? 0 : k + 1);
      for(std::size_t i = starts_[k]; after(i) != end(k); i = after(i))
        triangles_.push_back({i, after(i), inner});
      triangles_.push_back({before(end(k)), end(k), next});
      triangles_.push_back({before(end(k)), next, inner});
      inner_.normals_beyond.push_back(normal(triangles_.back()));
    }
  }

  Vector normal(const Triangle& t) const {
    const auto point = [this](std::size_t i) {
      const auto& p = i < size() ? polygon_.points[i] : inner_.points[i - size()];
      return Simple_cartesian<double>::Point_3(p.x(), p.y(), p.z());
    };
    return CGAL::cross_product(point(t[1]) - point(t[0]), point(t[2]) - point(t[0]));
  }

  const Polygon_in_space& polygon_;
  const double side_, height_;
  std::vector<std::size_t> starts_;
  std::vector<Triangle> triangles_;
  Polygon_in_space inner_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_COLLAR_H
