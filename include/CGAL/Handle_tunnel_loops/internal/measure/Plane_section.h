// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PLANE_SECTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PLANE_SECTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The part around a place of the section, by a plane, of the solid or of what is around it: where it
ends at the surface all around, it is a cap.

On which side of the plane a vertex is, is decided once, and each edge is cut once: so the section
of the surface is closed curves.
*/
class Plane_section
{
public:
  Plane_section(const Face_tree& faces,
                Span<const Vector> points,
                const Vector& place,
                const Vector& normal)
      : place_(place)
      , normal_(unit(normal)) {
    const Vector aside = std::abs(normal_[0]) < 0.6 ? Vector{1., 0., 0.} : Vector{0., 1., 0.};
    axes_[0] = unit(cross(normal_, aside));
    axes_[1] = cross(normal_, axes_[0]);
    std::vector<std::pair<Point, Point>> cuts;
    for(Index f = 0; f < faces.size(); ++f)
      add_cut(faces.corners(f), points, cuts);
    triangulation_.insert_constraints(cuts.begin(), cuts.end());
    if(triangulation_.dimension() == 2)
      take_around(triangulation_.locate(Point(0., 0.)));
  }

  /// none if it goes on and on.
  const std::vector<std::array<Vector, 3>>& triangles() const { return triangles_; }

  /// how often a closed way passes, and back negative.
  int passages(const std::vector<Free_ball>& way) const {
    int sum = 0;
    for(std::size_t i = 0; i < way.size(); ++i) {
      const Vector &a = way[i].place, &b = way[i + 1 < way.size() ? i + 1 : 0].place;
      if(const bool is_up = is_above(b);
         is_up != is_above(a) &&
         triangulation_.locate(is_up ? crossing(b, a) : crossing(a, b))->info())
        sum += is_up ? 1 : -1;
    }
    return sum;
  }

private:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Face_base =
      Triangulation_face_base_with_info_2<bool, // whether it is taken
                                          Kernel,
                                          Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation = Constrained_Delaunay_triangulation_2<
      Kernel,
      Triangulation_data_structure_2<Triangulation_vertex_base_2<Kernel>, Face_base>,
      Exact_predicates_tag>;
  using Point = Kernel::Point_2;

  double height(const Vector& p) const { return dot(p - place_, normal_); }
  bool is_above(const Vector& p) const { return height(p) > 0.; }

  void add_cut(const Face_tree::Corners& corners,
               Span<const Vector> points,
               std::vector<std::pair<Point, Point>>& cuts) const {
    std::array<bool, 3> above;
    for(int k = 0; k < 3; ++k)
      above[k] = is_above(points[corners[k]]);
    if(above[0] == above[1] && above[1] == above[2])
      return;
    std::array<Point, 2> ends;
    std::size_t n = 0;
    for(int k = 0; k < 3; ++k)
      if(const int l = (k + 1) % 3; above[k] != above[l])
        ends[n++] = above[k] ? crossing(points[corners[k]], points[corners[l]])
                             : crossing(points[corners[l]], points[corners[k]]);
    if(ends[0] != ends[1])
      cuts.emplace_back(ends[0], ends[1]);
  }

  // Of a segment from a point above, from both sides of an edge the same.
  Point crossing(const Vector& above, const Vector& below) const {
    const double up = height(above), t = up / (up - height(below));
    const Vector off = above + t * (below - above) - place_;
    return {dot(off, axes_[0]), dot(off, axes_[1])};
  }

  Vector in_space(const Point& p) const { return place_ + p.x() * axes_[0] + p.y() * axes_[1]; }

  void take_around(Triangulation::Face_handle first) {
    for(const Triangulation::Face_handle f : triangulation_.all_face_handles())
      f->info() = f == first;
    std::vector<Triangulation::Face_handle> stack(1, first);
    while(!stack.empty()) {
      const Triangulation::Face_handle f = stack.back();
      stack.pop_back();
      if(triangulation_.is_infinite(f)) {
        triangles_.clear();
        return;
      }
      triangles_.push_back({in_space(f->vertex(0)->point()), in_space(f->vertex(1)->point()),
                            in_space(f->vertex(2)->point())});
      for(int k = 0; k < 3; ++k)
        if(const auto g = f->neighbor(k); !f->is_constrained(k) && !g->info()) {
          g->info() = true;
          stack.push_back(g);
        }
    }
  }

  Vector place_, normal_;
  std::array<Vector, 2> axes_;
  Triangulation triangulation_;
  std::vector<std::array<Vector, 3>> triangles_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_PLANE_SECTION_H
