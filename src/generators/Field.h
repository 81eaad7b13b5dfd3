// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FIELD_H

#include "generators.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {

using Vector = CGAL::Simple_cartesian<double>::Vector_3;

inline double length(const Vector& v) { return std::sqrt(v.squared_length()); }
inline Vector unit(const Vector& v) { return v / length(v); }

/// how far a point is from a segment.
inline double segment_distance(const Vector& p, const Vector& a, const Vector& b) {
  const Vector along = b - a, from = p - a;
  const double square = along.squared_length();
  const double t = square > 0. ? std::clamp((from * along) / square, 0., 1.) : 0.;
  return length(from - t * along);
}

/// An axis-parallel box.
struct Box
{
  Vector low, high;

  /// the smallest box that also holds a point.
  Box with(const Vector& p) const {
    return {
        Vector((std::min)(low.x(), p.x()), (std::min)(low.y(), p.y()), (std::min)(low.z(), p.z())),
        Vector((std::max)(high.x(), p.x()), (std::max)(high.y(), p.y()),
               (std::max)(high.z(), p.z()))};
  }

  /// the corner that is high along the axes whose bits are set.
  Vector corner(int bits) const {
    return Vector((bits & 1) != 0 ? high.x() : low.x(), (bits & 2) != 0 ? high.y() : low.y(),
                  (bits & 4) != 0 ? high.z() : low.z());
  }

  /// the box whose faces are further out.
  Box grown(double distance) const {
    const Vector d(distance, distance, distance);
    return {low - d, high + d};
  }
};

/// A solid given by a function that is negative inside, positive outside, and nowhere larger, in
/// absolute value, than the distance to the solid's surface.
class Field
{
public:
  virtual ~Field() = default;
  virtual double operator()(const Vector& p) const = 0;
  virtual Box box() const = 0; ///< a box around the solid
};

inline Vector point_of(const Soup& soup, std::uint32_t v) {
  const auto& [x, y, z] = soup.points[v];
  return Vector(x, y, z);
}

/// returns the number of the point.
inline std::uint32_t add_point(Soup& soup, const Vector& p) {
  soup.points.push_back({p.x(), p.y(), p.z()});
  look_at(soup, soup.points.size());
  return static_cast<std::uint32_t>(soup.points.size() - 1);
}

inline double mean_edge_length(const Soup& soup) {
  double sum = 0.;
  for(const auto& triangle : soup.triangles)
    for(int i = 0; i < 3; ++i)
      sum += length(point_of(soup, triangle[i]) - point_of(soup, triangle[(i + 1) % 3]));
  return sum / (3. * static_cast<double>(soup.triangles.size()));
}

/// for each vertex the sum of the normals of its triangles, each as long as twice its area.
inline std::vector<Vector> vertex_normals(const Soup& soup) {
  std::vector<Vector> normals(soup.points.size(), Vector(0, 0, 0));
  for(const auto& [a, b, c] : soup.triangles) {
    const Vector p = point_of(soup, a);
    const Vector normal = CGAL::cross_product(point_of(soup, b) - p, point_of(soup, c) - p);
    for(const std::uint32_t v : {a, b, c})
      normals[v] += normal;
  }
  return normals;
}

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FIELD_H
