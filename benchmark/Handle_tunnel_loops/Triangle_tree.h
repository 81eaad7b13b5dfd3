// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_TRIANGLE_TREE_H
#define BENCHMARK_TRIANGLE_TREE_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

/// \file Triangle_tree.h
/// How far points are from triangles, slivers among them.

namespace voxel_measures {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Triangle = std::array<Point, 3>;

inline Point closest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Vector way = b - a;
  const double square = way * way;
  return square > 0. ? a + std::clamp((p - a) * way / square, 0., 1.) * way : a;
}

inline double distance(const Point& a, const Point& b) { return std::sqrt((b - a) * (b - a)); }

inline double squared_distance(const Point& a, const Point& b) { return (b - a) * (b - a); }

inline Point closest_on_triangle(const Point& p, const Triangle& t) {
  const Vector normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
  const double square = normal * normal;
  double most = 0.;
  bool is_above = true; // the triangle
  for(int i = 0; i < 3; ++i) {
    const Point &a = t[i], &b = t[(i + 1) % 3];
    is_above = is_above && CGAL::cross_product(b - a, p - a) * normal >= 0.;
    most = (std::max)(most, squared_distance(a, b));
  }
  if(is_above && square > 1e-20 * most * most) // else it is no more than its sides
    return p - ((p - t[0]) * normal / square) * normal;
  Point best = closest_on_segment(p, t[0], t[1]);
  for(const Point& q : {closest_on_segment(p, t[1], t[2]), closest_on_segment(p, t[2], t[0])})
    if(squared_distance(p, q) < squared_distance(p, best))
      best = q;
  return best;
}

inline double distance(const Point& p, const Triangle& t) {
  return distance(p, closest_on_triangle(p, t));
}

/// Boxes in boxes, halved in the middle.
class Triangle_tree
{
public:
  struct Nearest
  {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t triangle = 0;
    Point place;
  };

  explicit Triangle_tree(std::vector<Triangle> triangles)
      : triangles_(std::move(triangles)) {
    for(std::size_t i = 0; i < triangles_.size(); ++i)
      order_.push_back(std::uint32_t(i));
    build(0, order_.size());
  }

  const std::vector<Triangle>& triangles() const { return triangles_; }
  CGAL::Bbox_3 box() const { return nodes_[0].box; }

  Nearest nearest(const Point& p) const {
    Nearest best;
    search(0, p, best);
    return best;
  }

private:
  struct Node
  {
    CGAL::Bbox_3 box;
    std::size_t first, last, right; ///< leaves have no right one
  };

  std::size_t build(std::size_t first, std::size_t last) {
    const std::size_t node = nodes_.size();
    CGAL::Bbox_3 box;
    for(std::size_t i = first; i < last; ++i)
      box += CGAL::bbox_3(triangles_[order_[i]].begin(), triangles_[order_[i]].end());
    nodes_.push_back({box, first, last, 0});
    if(last - first > 4) {
      int axis = 0;
      for(int i = 1; i < 3; ++i)
        if((box.max)(i) - (box.min)(i) > (box.max)(axis) - (box.min)(axis))
          axis = i;
      const auto middle = [&](std::uint32_t t) {
        return triangles_[t][0][axis] + triangles_[t][1][axis] + triangles_[t][2][axis];
      };
      const std::size_t half = (first + last) / 2;
      std::nth_element(order_.begin() + long(first), order_.begin() + long(half),
                       order_.begin() + long(last),
                       [&](auto a, auto b) { return middle(a) < middle(b); });
      build(first, half);
      nodes_[node].right = build(half, last);
    }
    return node;
  }

  static double distance_to(const CGAL::Bbox_3& box, const Point& p) {
    double sum = 0.;
    for(int i = 0; i < 3; ++i) {
      const double away = (std::max)({(box.min)(i)-p[i], p[i] - (box.max)(i), 0.});
      sum += away * away;
    }
    return std::sqrt(sum);
  }

  void search(std::size_t n, const Point& p, Nearest& best) const {
    const Node& node = nodes_[n];
    if(node.right == 0) {
      for(std::size_t i = node.first; i < node.last; ++i) {
        const Triangle& t = triangles_[order_[i]];
        if(distance_to(CGAL::bbox_3(t.begin(), t.end()), p) >= best.distance)
          continue;
        const Point q = closest_on_triangle(p, t);
        if(const double d = distance(p, q); d < best.distance)
          best = {d, order_[i], q};
      }
      return;
    }
    std::array<std::pair<double, std::size_t>, 2> halves = {
        std::make_pair(distance_to(nodes_[n + 1].box, p), n + 1),
        std::make_pair(distance_to(nodes_[node.right].box, p), node.right)};
    if(halves[1].first < halves[0].first)
      std::swap(halves[0], halves[1]);
    for(const auto& [away, half] : halves)
      if(away < best.distance)
        search(half, p, best);
  }

  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

} // namespace voxel_measures

#endif // BENCHMARK_TRIANGLE_TREE_H
