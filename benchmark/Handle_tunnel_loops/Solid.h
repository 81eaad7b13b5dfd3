// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_SOLID_H
#define BENCHMARK_SOLID_H

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <boost/variant.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <vector>

/// \file Solid.h
/// What lies inside a surface, by CGAL's own searches.

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Solid_mesh = CGAL::Surface_mesh<Point>;

/// What is inside, and how far away the surface is.
class Solid
{
public:
  explicit Solid(const Solid_mesh& mesh)
      : tree_(faces(mesh).begin(), faces(mesh).end(), mesh) {
    tree_.accelerate_distance_queries();
    sides_.emplace_back(tree_);
  }

  /// Inside is what is inside any of the components, which have to outlive this.
  Solid(const Solid_mesh& mesh, const std::vector<Solid_mesh>& components)
      : tree_(faces(mesh).begin(), faces(mesh).end(), mesh) {
    tree_.accelerate_distance_queries();
    for(const Solid_mesh& component : components)
      sides_.emplace_back(component);
  }

  bool contains(const Point& p) const {
    return std::any_of(sides_.begin(), sides_.end(),
                       [&p](const Side& side) { return side(p) != CGAL::ON_UNBOUNDED_SIDE; });
  }

  double distance(const Point& p) const { return std::sqrt(tree_.squared_distance(p)); }

  // The length of the part of a segment that is inside.
  double length_inside(const Point& a, const Point& b) const {
    const Kernel::Vector_3 way = b - a;
    const double squared_length = way.squared_length();
    if(!(squared_length > 0.))
      return 0.;
    std::vector<double> cuts = {0., 1.};
    for(const Point& p : crossings({a, b}))
      cuts.push_back(std::clamp(((p - a) * way) / squared_length, 0., 1.));
    std::sort(cuts.begin(), cuts.end());
    double inside = 0.;
    for(std::size_t i = 1; i < cuts.size(); ++i)
      if(cuts[i] > cuts[i - 1] && contains(a + (0.5 * (cuts[i - 1] + cuts[i])) * way))
        inside += cuts[i] - cuts[i - 1];
    return inside * std::sqrt(squared_length);
  }

private:
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Solid_mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  using Side = CGAL::Side_of_triangle_mesh<Solid_mesh, Kernel>;

  // The ends of those that run in a face.
  std::vector<Point> crossings(const Kernel::Segment_3& segment) const {
    std::vector<Tree::Intersection_and_primitive_id<Kernel::Segment_3>::Type> found;
    tree_.all_intersections(segment, std::back_inserter(found));
    std::vector<Point> points;
    for(const auto& one : found)
      if(const Point* p = boost::get<Point>(&one.first))
        points.push_back(*p);
      else if(const auto* s = boost::get<Kernel::Segment_3>(&one.first))
        points.insert(points.end(), {s->source(), s->target()});
    return points;
  }

  Tree tree_;
  std::deque<Side> sides_;
};

#endif // BENCHMARK_SOLID_H
