// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_SURFACE_DISTANCE_H
#define BENCHMARK_SURFACE_DISTANCE_H

#include "Judged_faces.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

/// \file Surface_distance.h
/// How far points are from a mesh.

namespace judge {

class Surface_distance
{
public:
  /// Faces not higher than a length are left out: their neighbours are as near.
  Surface_distance(const Mesh& mesh, double height)
      : Surface_distance(mesh, mesh.faces(), height) {}

  /// to some of the faces only.
  template <typename Faces> Surface_distance(const Mesh& mesh, const Faces& faces, double height) {
    for(const Mesh::Face_index f : faces) {
      const Triangle t = triangle_of(mesh, f);
      if(is_needle(t, height))
        continue;
      triangles_.emplace_back(t[0], t[1], t[2]);
      faces_.push_back(f);
    }
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
    if(!faces_.empty())
      tree_.accelerate_distance_queries();
  }

  Surface_distance(const Surface_distance&) = delete;
  Surface_distance& operator=(const Surface_distance&) = delete;

  bool is_empty() const { return faces_.empty(); }

  double operator()(const Point& p) const { return std::sqrt(tree_.squared_distance(p)); }

  Mesh::Face_index nearest_face(const Point& p) const {
    const auto place = tree_.closest_point_and_primitive(p).second;
    return faces_[std::size_t(place - triangles_.begin())];
  }

  /// the most over the samples of a triangle.
  double most(const Triangle& t, double step) const {
    double most = 0.;
    for(const Point& p : samples_of(t, step))
      most = (std::max)(most, (*this)(p));
    return most;
  }

  /// whether centroid, corners and midpoints of edges are.
  bool is_near(const Triangle& t, double distance) const {
    const std::array<Point, 7> points = {CGAL::centroid(t[0], t[1], t[2]),
                                         CGAL::midpoint(t[0], t[1]),
                                         CGAL::midpoint(t[1], t[2]),
                                         CGAL::midpoint(t[2], t[0]),
                                         t[0],
                                         t[1],
                                         t[2]};
    return std::all_of(points.begin(), points.end(),
                       [&](const Point& p) { return (*this)(p) <= distance; });
  }

  /// whether a line to far away crosses the surface an odd number of times.
  bool is_inside(const Point& p) const {
    return tree_.number_of_intersected_primitives(
               Kernel::Ray_3(p, Vector(0.5479, 0.3217, 0.7721))) %
               2 ==
           1;
  }

private:
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>;

  Triangles triangles_;
  std::vector<Mesh::Face_index> faces_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

} // namespace judge

#endif // BENCHMARK_SURFACE_DISTANCE_H
