// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGULATED_POLYGON_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGULATED_POLYGON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Polygon_in_space.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Sheared_circles.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Fills a polygon by triangles without points of their own: by those of least cost, as in P. Liepa,
*Filling holes in meshes* (2003), which is their area, and how far they bend at their edges. That
takes the cube of the number of points. Where there are many, they are triangulated as they are seen
from the side where the polygon looks largest; or, if it crosses itself from there, a few of them
are taken first. A polygon in a plane is triangulated as it is seen along an axis of space: nothing
is rounded then, and triangles do not meet even where corners are all but on a line.

What is found depends on the order of the points alone. Costs are rounded: they choose between
triangulations of which all are right.
*/
class Triangulated_polygon
{
  using Kernel = Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;

public:
  /// the corners, in the order of the polygon. No triangle comes before one that is between two
  /// of its corners.
  using Triangle = std::array<std::size_t, 3>;

  explicit Triangulated_polygon(const Polygon_in_space& polygon)
      : polygon_(polygon)
      , scaled_(polygon) {
    if(!scaled_.is_good())
      return;
    std::vector<std::size_t> all(polygon.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      all[i] = i;
    is_good_ = (scaled_.is_flat() && fill_as_seen<Sheared_circles>(all, along_axis())) || fill(all);
    if(!is_good_)
      return;
    std::sort(triangles_.begin(), triangles_.end(), [](const Triangle& s, const Triangle& t) {
      return std::make_pair(s[2] - s[0], s) < std::make_pair(t[2] - t[0], t);
    });
  }

  /// whether there are triangles, none of them on a line.
  bool is_good() const { return is_good_; }

  const std::vector<Triangle>& triangles() const { return triangles_; }

private:
  using Corners = std::vector<std::size_t>; // of a polygon, by their numbers in the whole one

  static constexpr std::size_t most_for_cubic = 100;

  bool fill(const Corners& corners) {
    if(corners.size() < 3)
      return true;
    if(corners.size() <= most_for_cubic)
      return fill_at_least_cost(corners);
    return fill_as_seen<Plane>(corners, from_largest_side()) || fill_few_first(corners);
  }

  // Some points far from each other, and then what is between them.
  bool fill_few_first(const Corners& corners) {
    constexpr std::size_t number = 64;
    const std::size_t n = corners.size();
    Corners few;
    for(std::size_t k = 0; k < number; ++k)
      few.push_back(corners[k * n / number]);
    if(!fill_at_least_cost(few))
      return false;
    for(std::size_t k = 0; k < number; ++k) {
      const std::size_t begin = k * n / number, end = (k + 1) * n / number;
      Corners between(corners.begin() + begin, corners.begin() + (std::min)(end + 1, n));
      if(end == n)
        between.insert(between.begin(), corners.front());
      if(between.size() > 2 && !fill(between))
        return false;
    }
    return true;
  }

  bool may_join(std::size_t i, std::size_t j) const {
    const bool is_side = j - i == 1 || (i == 0 && j + 1 == scaled_.points.size());
    return is_side || !polygon_.are_joined || !polygon_.are_joined(i, j);
  }

  bool is_degenerate(std::size_t i, std::size_t k, std::size_t j, const Vector& normal) const {
    constexpr double surely_not = 1e-20;
    return normal.squared_length() < surely_not &&
           CGAL::collinear(polygon_.points[i], polygon_.points[k], polygon_.points[j]);
  }

  // ---- at least cost

  // Of what fills the part of a polygon from one corner to another.
  struct Part
  {
    double cost = (std::numeric_limits<double>::infinity)();
    std::size_t apex = 0;
    Vector normal = Vector(NULL_VECTOR); // of the triangle at the side from one to the other
  };

  bool fill_at_least_cost(const Corners& corners) {
    const std::size_t n = corners.size();
    std::vector<Part> parts(n * n);
    for(std::size_t i = 0; i + 1 < n; ++i)
      parts[i * n + i + 1] = {0., 0, normal_beyond(corners[i], corners[i + 1])};
    for(std::size_t span = 2; span < n; ++span)
      for(std::size_t i = 0; i + span < n; ++i)
        find_part(corners, i, i + span, parts);
    if(!(parts[n - 1].cost < (std::numeric_limits<double>::infinity)()))
      return false;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
    while(!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if(j - i < 2)
        continue;
      const std::size_t k = parts[i * n + j].apex;
      triangles_.push_back({corners[i], corners[k], corners[j]});
      open.insert(open.end(), {{i, k}, {k, j}});
    }
    return true;
  }

  void
  find_part(const Corners& corners, std::size_t i, std::size_t j, std::vector<Part>& parts) const {
    const std::size_t n = corners.size();
    if(!may_join(corners[i], corners[j]))
      return;
    const Point &p = scaled_.points[corners[i]], &q = scaled_.points[corners[j]];
    const bool is_last = j - i == n - 1;
    const Vector last = is_last ? normal_beyond(corners[j], corners[i]) : Vector(NULL_VECTOR);
    Part& best = parts[i * n + j];
    for(std::size_t k = i + 1; k < j; ++k) {
      const Part &left = parts[i * n + k], &right = parts[k * n + j];
      double cost = left.cost + right.cost;
      if(!(cost < best.cost))
        continue;
      const Point& r = scaled_.points[corners[k]];
      const Vector normal = CGAL::cross_product(r - p, q - p);
      cost += cost_of(normal) + length_cost(p, q);
      if(!(cost < best.cost) || is_degenerate(corners[i], corners[k], corners[j], normal) ||
         (k == i + 1 && !may_stand_on(left.normal, normal, r - p)) ||
         (j == k + 1 && !may_stand_on(right.normal, normal, q - r)) ||
         !may_stand_on(last, normal, p - q))
        continue;
      cost += cost_at(k == i + 1, left.normal, normal, r - p) +
              cost_at(j == k + 1, right.normal, normal, q - r) + cost_at(true, last, normal, p - q);
      if(cost < best.cost)
        best = {cost, k, normal};
    }
  }

  // The triangle from i over k to j, as the polygon goes: its normal is that of the filling.
  static double cost_of(const Vector& normal) { return 0.5 * std::sqrt(normal.squared_length()); }

  static double length_cost(const Point& p, const Point& q) {
    constexpr double weight = 0.01;
    return weight * CGAL::squared_distance(p, q);
  }

  // Of the angle at an edge between a triangle and the one before, or a face beyond a side of the
  // polygon. Folds, and corners that are cut off within these faces, must not pay by the area that
  // they save: that is in proportion to their length.
  double cost_at(bool is_side, const Vector& m, const Vector& n, const Vector& along) const {
    const double lengths = m.squared_length() * n.squared_length();
    if(!(lengths > 0.))
      return 0.;
    const double cosine = (m * n) / std::sqrt(lengths), square = along.squared_length(),
                 length = std::sqrt(square);
    if(!is_side || polygon_.at_sides == Polygon_in_space::CONTINUED) {
      const double folded = (std::max)(0., -cosine);
      return 0.1 * square * (1. - cosine) + 0.5 * length * folded * folded;
    }
    return 0.2 * length * (1. - rise(m, n, along));
  }

  // The sine of the angle at which a triangle stands on the face beyond a side, on the side of it
  // that is asked for.
  double rise(const Vector& m, const Vector& n, const Vector& along) const {
    const double sine = CGAL::cross_product(n, along) * m /
                        std::sqrt(along.squared_length() * m.squared_length() * n.squared_length());
    return polygon_.at_sides == Polygon_in_space::OUTSIDE ? sine : -sine;
  }

  // What lies on the other side of the surface would cross it, and what leans on it is a fold.
  bool may_stand_on(const Vector& m, const Vector& n, const Vector& along) const {
    constexpr double least = 0.87; // of 60 degrees
    return polygon_.at_sides == Polygon_in_space::CONTINUED ||
           !(m.squared_length() * n.squared_length() > 0.) || rise(m, n, along) >= least;
  }

  Vector normal_beyond(std::size_t i, std::size_t j) const {
    const bool is_side = j == i + 1 || (j == 0 && i + 1 == scaled_.points.size());
    return is_side && !polygon_.normals_beyond.empty() ? polygon_.normals_beyond[i]
                                                       : Vector(NULL_VECTOR);
  }

  // ---- as seen from a side

  using Plane = Exact_predicates_inexact_constructions_kernel;
  using Picture = std::vector<Plane::Point_2>; // of all corners

  template <typename Traits> bool fill_as_seen(const Corners& corners, const Picture& picture) {
    using Vertex_base = Triangulation_vertex_base_with_info_2<std::size_t, Traits>;
    using Face_base = Constrained_triangulation_face_base_2<Traits>;
    using Triangulation =
        Constrained_Delaunay_triangulation_2<Traits,
                                             Triangulation_data_structure_2<Vertex_base, Face_base>,
                                             No_constraint_intersection_tag>;
    if(picture.empty())
      return false;
    Triangulation cdt;
    std::vector<typename Triangulation::Vertex_handle> vertices(corners.size());
    for_each_from_coarse_to_fine(corners.size(), [&](std::size_t k, std::size_t known) {
      vertices[k] = cdt.insert(picture[corners[k]], k == 0 ? nullptr : vertices[known]->face());
      vertices[k]->info() = corners[k];
    });
    if(cdt.number_of_vertices() != corners.size() || cdt.dimension() != 2)
      return false;
    try {
      for(std::size_t k = 0; k < corners.size(); ++k)
        cdt.insert_constraint(vertices[k], vertices[(k + 1) % corners.size()]);
    } catch(const typename Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return take_inner(cdt, corners.size() - 2);
  }

  // Calls `f(k, known)` for 0 .. n - 1, where `known` was there before, for k > 0: from one end to
  // the other each would change most of the triangles of those that lie all but on a circle.
  template <typename Function>
  static void for_each_from_coarse_to_fine(std::size_t n, const Function& f) {
    std::size_t step = 1;
    while(step < n)
      step *= 2;
    f(0, 0);
    for(; step > 1; step /= 2)
      for(std::size_t known = 0; known + step / 2 < n; known += step)
        f(known + step / 2, known);
  }

  Picture from_largest_side() const {
    Picture picture;
    if(scaled_.normal == Vector(NULL_VECTOR))
      return picture;
    const auto [x, y] = axes();
    for(const Point& p : scaled_.points) {
      const Vector v = p - scaled_.center;
      // As in `Sheared_circles`, and faster.
      picture.emplace_back(v * x + 1.3e-3 * (v * y), 1.0007 * (v * y));
    }
    return picture;
  }

  // That from which a polygon in a plane looks largest.
  Picture along_axis() const {
    int axis = 0;
    for(int other : {1, 2})
      if(std::abs(scaled_.normal[other]) > std::abs(scaled_.normal[axis]))
        axis = other;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    if(scaled_.normal[axis] < 0.)
      std::swap(x, y);
    Picture picture;
    for(const Surgery_mesh::Point& p : polygon_.points)
      picture.emplace_back(p[x], p[y]);
    return picture;
  }

  std::pair<Vector, Vector> axes() const {
    const Vector n = scaled_.normal / std::sqrt(scaled_.normal.squared_length());
    const Vector x0 = std::abs(n.x()) < 0.6   ? Vector(1., 0., 0.)
                      : std::abs(n.y()) < 0.6 ? Vector(0., 1., 0.)
                                              : Vector(0., 0., 1.);
    Vector x = x0 - (x0 * n) * n;
    x = x / std::sqrt(x.squared_length());
    return {x, CGAL::cross_product(n, x)};
  }

  // Those within the constraints, if there are as many as there should be.
  template <typename Triangulation> bool take_inner(const Triangulation& cdt, std::size_t number) {
    std::map<typename Triangulation::Face_handle, bool> is_outer;
    std::vector<typename Triangulation::Face_handle> open{cdt.infinite_face()};
    is_outer[open.front()] = true;
    while(!open.empty()) {
      const auto f = open.back();
      open.pop_back();
      for(int i = 0; i < 3; ++i)
        if(!f->is_constrained(i) && is_outer.insert({f->neighbor(i), true}).second)
          open.push_back(f->neighbor(i));
    }
    std::vector<Triangle> inner;
    for(auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) {
      if(is_outer.count(f) != 0)
        continue;
      const Triangle t{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
      if(!is_fit(t))
        return false;
      inner.push_back(ascending(t));
    }
    if(inner.size() != number)
      return false;
    triangles_.insert(triangles_.end(), inner.begin(), inner.end());
    return true;
  }

  static Triangle ascending(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  }

  bool is_fit(const Triangle& corners) const {
    const Triangle t = ascending(corners);
    // As the polygon goes: from the side that it is seen from, it turns left.
    const bool is_turned =
        (corners[0] < corners[1]) + (corners[1] < corners[2]) + (corners[2] < corners[0]) != 2;
    const Vector normal = CGAL::cross_product(scaled_.points[t[1]] - scaled_.points[t[0]],
                                              scaled_.points[t[2]] - scaled_.points[t[0]]);
    return !is_turned && may_join(t[0], t[1]) && may_join(t[1], t[2]) && may_join(t[0], t[2]) &&
           !is_degenerate(t[0], t[1], t[2], normal);
  }

  const Polygon_in_space& polygon_;
  const Scaled_polygon scaled_;
  bool is_good_ = false;
  std::vector<Triangle> triangles_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_TRIANGULATED_POLYGON_H
