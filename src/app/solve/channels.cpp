// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/channels.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace htloops {
namespace {

using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Hull_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hull = CGAL::Surface_mesh<Hull_kernel::Point_3>;
using Side_of_hull = CGAL::Side_of_triangle_mesh<Hull, Hull_kernel>;

Triangles triangles_of(const Mesh& mesh) {
  Triangles triangles;
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    triangles.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                           mesh.point(mesh.target(mesh.next(h))));
  }
  return triangles;
}

Hull_kernel::Point_3 hull_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

Hull hull_of(const Mesh& mesh) {
  std::vector<Hull_kernel::Point_3> points;
  for(const Point& p : mesh.points())
    points.push_back(hull_point(p));
  Hull hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return hull;
}

// A closed curve, with further points, so that none is too far from the next one.
std::vector<Point> refined(const std::vector<Point>& curve, double step) {
  constexpr double most_points = 10000.;
  std::vector<Point> points;
  for(std::size_t i = 0; i < curve.size(); ++i) {
    const Point &from = curve[i], &to = curve[(i + 1) % curve.size()];
    const double length = std::sqrt(CGAL::squared_distance(from, to));
    const double parts = (std::min)(std::ceil(length / step), most_points);
    for(double k = 0.; k < (std::max)(parts, 1.); k += 1.)
      points.push_back(from + (k / (std::max)(parts, 1.)) * (to - from));
  }
  return points;
}

// Of a closed curve that begins at the throat, the part around that within the hull; with one point
// outside at either end.
std::vector<Point> within_hull(const std::vector<Point>& curve, const Side_of_hull& side) {
  const auto is_outside = [&side](const Point& p) {
    return side(hull_point(p)) == CGAL::ON_UNBOUNDED_SIDE;
  };
  const auto end = std::find_if(curve.begin(), curve.end(), is_outside);
  if(end == curve.end())
    return curve;
  const auto begin = std::find_if(curve.rbegin(), curve.rend(), is_outside);
  std::vector<Point> part(std::prev(begin.base()), curve.end());
  part.insert(part.end(), curve.begin(), std::next(end));
  return part;
}

} // namespace

std::vector<Channel> find_channels(const Mesh& mesh, const Measures& measures) {
  const Triangles triangles = triangles_of(mesh);
  const Tree tree(triangles.begin(), triangles.end());
  const Hull hull = hull_of(mesh);
  const Side_of_hull side(hull);
  std::vector<Channel> channels;
  for(std::size_t pair = 0; pair < measures.size(); ++pair) {
    const auto& ball = measures[pair].clear_width;
    if(!ball || ball->curve.empty() || !(ball->diameter > 0.))
      continue;
    const std::vector<Point> curve = refined(ball->curve, ball->diameter / 4.);
    Channel channel = {pair, ball->diameter, false, within_hull(curve, side), {}};
    channel.is_closed = channel.points.size() == curve.size();
    for(const Point& p : channel.points)
      channel.radii.push_back(std::sqrt(tree.squared_distance(p)));
    channels.push_back(std::move(channel));
  }
  return channels;
}

std::vector<double> distances_to_surface(const Mesh& mesh, const std::vector<Point>& points) {
  // Squares may be too large, or too small. Powers of two round nothing.
  double largest = 0.;
  for(const Point& p : mesh.points())
    largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  const int exponent = largest > 0. ? std::ilogb(largest) : 0;
  const auto scaled = [exponent](const Point& p) {
    return Point(std::ldexp(p.x(), -exponent), std::ldexp(p.y(), -exponent),
                 std::ldexp(p.z(), -exponent));
  };
  Triangles triangles;
  for(const Triangle& t : triangles_of(mesh))
    triangles.emplace_back(scaled(t[0]), scaled(t[1]), scaled(t[2]));
  const Tree tree(triangles.begin(), triangles.end());
  std::vector<double> distances;
  for(const Point& p : points)
    distances.push_back(std::ldexp(std::sqrt(tree.squared_distance(scaled(p))), exponent));
  return distances;
}

} // namespace htloops
