// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_JUDGED_FACES_H
#define BENCHMARK_JUDGED_FACES_H

#include "Benchmark_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file Judged_faces.h
/// Single triangles: areas, normals, angles, and points on them. Nothing here or in what includes
/// it is shared with the removal of handles, so that neither hides the mistakes of the other.

namespace judge {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangle = std::array<Point, 3>;

constexpr std::size_t nobody = std::size_t(-1); ///< what belongs to no handle

inline Point point_of(const Mesh& mesh, Mesh::Vertex_index v) {
  const auto& p = mesh.point(v);
  return Point(p.x(), p.y(), p.z());
}

inline Triangle triangle_of(const Mesh& mesh, Mesh::Face_index f) {
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return {point_of(mesh, mesh.source(h)), point_of(mesh, mesh.target(h)),
          point_of(mesh, mesh.target(mesh.next(h)))};
}

inline double length_of(const Vector& v) { return std::sqrt(v.squared_length()); }

/// as long as twice the area.
inline Vector normal_of(const Triangle& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]); }

inline double area_of(const Triangle& t) { return length_of(normal_of(t)) / 2.; }

inline double longest_edge(const Triangle& t) {
  return (std::max)({length_of(t[1] - t[0]), length_of(t[2] - t[1]), length_of(t[0] - t[2])});
}

inline double diagonal_of(const Mesh& mesh) {
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return length_of(Vector(box.x_span(), box.y_span(), box.z_span()));
}

/// whether the direction of the normal says nothing: the triangle is not higher than a length.
inline bool is_needle(const Triangle& t, double height) {
  return !(2. * area_of(t) > height * longest_edge(t));
}

/// six times the volume between the triangle and a point.
inline double six_volumes(const Triangle& t, const Point& origin) {
  return (t[0] - origin) * CGAL::cross_product(t[1] - origin, t[2] - origin);
}

/// in degrees, 0 where the faces lie in a plane, 180 where one lies on the other.
inline double bend_between(const Vector& a, const Vector& b) {
  return std::atan2(length_of(CGAL::cross_product(a, b)), a * b) * 180. / CGAL_PI;
}

/// corners, points on edges and in the interior, at most a step apart, and not more than 66.
inline std::vector<Point> samples_of(const Triangle& t, double step) {
  const int n = int(std::clamp(std::ceil(longest_edge(t) / step), 2., 10.));
  std::vector<Point> samples;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; i + j <= n; ++j)
      samples.push_back(t[0] + (double(i) / n) * (t[1] - t[0]) + (double(j) / n) * (t[2] - t[0]));
  samples.push_back(CGAL::centroid(t[0], t[1], t[2]));
  return samples;
}

} // namespace judge

#endif // BENCHMARK_JUDGED_FACES_H
