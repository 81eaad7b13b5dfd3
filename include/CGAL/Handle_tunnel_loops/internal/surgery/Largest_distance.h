// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LARGEST_DISTANCE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LARGEST_DISTANCE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How far points of some triangles are from others, at most.
class Largest_distance
{
public:
  using Kernel = Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Vector = Kernel::Vector_3;
  using Triangle = Kernel::Triangle_3;
  using Triangles = std::vector<Triangle>;

  /// Distances are measured up to a tolerance; above the limit, one that is above it is enough.
  struct Accuracy
  {
    double tolerance, limit;
  };

  /// to triangles none of which lies on a line.
  Largest_distance(Triangles to, const Accuracy& accuracy)
      : to_(std::move(to))
      , accuracy_(accuracy)
      , tree_(to_.begin(), to_.end()) {
    tree_.custom_build(tree_.traits().compute_bbox_object(), Halves_by_centers());
  }
  Largest_distance(const Largest_distance&) = delete;
  Largest_distance& operator=(const Largest_distance&) = delete;

  /// of any point of some triangles. What may be further away than is known is divided: where no
  /// point is further from its center than the radius; nor any point further from one of the others
  /// than the corners, as distances from a triangle are convex.
  double from(Triangles triangles) const {
    if(to_.empty())
      return 0.;
    double most = 0.;
    Primitive_id beside = to_.begin();
    while(!triangles.empty() && most <= accuracy_.limit) {
      const Triangle t = triangles.back();
      triangles.pop_back();
      const double enough = most + accuracy_.tolerance;
      if(distance_of_corners(t, *beside) <= enough)
        continue;
      const Point center = CGAL::centroid(t);
      const double radius = radius_around(center, t);
      if(has_within(enough - radius, center, beside))
        continue;
      if(!has_within(most, center, beside)) {
        // From there, as the tree would build another one to know where to begin.
        const auto nearest = tree_.closest_point_and_primitive(center, {(*beside)[0], beside});
        most = (std::max)(most, std::sqrt(CGAL::squared_distance(center, nearest.first)));
        beside = nearest.second;
      }
      if(radius > accuracy_.tolerance && distance_of_corners(t, *beside) > enough)
        divide(t, triangles);
    }
    return most;
  }

  /// of those points of some triangles that are above the others, as their normals point, or below
  /// if \p outward is negative. Triangles that lie below where they are asked are believed to come
  /// up through the others: what is above only beyond their rim may be missed.
  double above(double outward, Triangles triangles) const {
    if(to_.empty())
      return 0.;
    double most = 0.;
    auto nearest = std::make_pair(to_.front()[0], to_.begin());
    while(!triangles.empty() && most <= accuracy_.limit) {
      const Triangle t = triangles.back();
      triangles.pop_back();
      const double enough = most + accuracy_.tolerance;
      if(distance_of_corners(t, *nearest.second) <= enough)
        continue;
      const Point center = CGAL::centroid(t);
      nearest = tree_.closest_point_and_primitive(center, nearest);
      const double distance = std::sqrt(CGAL::squared_distance(center, nearest.first)),
                   radius = radius_around(center, t);
      const bool counts = outward * side(center, nearest) > 0.;
      if(counts)
        most = (std::max)(most, distance);
      if(radius > accuracy_.tolerance && (counts ? distance : -distance) + radius > enough &&
         distance_of_corners(t, *nearest.second) > enough)
        divide(t, triangles);
    }
    return most;
  }

  static Vector normal(const Triangle& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]); }

private:
  using Primitive_id = Triangles::const_iterator;
  using Tree = AABB_tree<AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Primitive_id>>>;

  // Halves triangles where their centers extend farthest: the halves of the wall of a bore by their
  // own extents, or by their corners, are as long as it, and go all around.
  struct Halves_by_centers
  {
    template <typename Iterator, typename Box_3>
    void operator()(Iterator begin, Iterator end, const Box_3&) const {
      Box<3> centers = Box<3>::empty();
      for(Iterator i = begin; i != end; ++i)
        centers.extend({center(*i), center(*i)});
      std::size_t axis = 0;
      for(std::size_t d = 1; d < 3; ++d)
        if(centers.high[d] - centers.low[d] > centers.high[axis] - centers.low[axis])
          axis = d;
      std::nth_element(begin, begin + (end - begin) / 2, end, [axis](const auto& s, const auto& t) {
        return std::make_pair(center(s)[axis], s.id()) < std::make_pair(center(t)[axis], t.id());
      });
    }

    template <typename Primitive> static std::array<double, 3> center(const Primitive& p) {
      const Point c = CGAL::centroid(*p.id());
      return {c.x(), c.y(), c.z()};
    }
  };

  using Nearest = Tree::Point_and_primitive_id;

  // What is within some distance of a point. Nodes are asked in squares.
  class Within
  {
  public:
    explicit Within(double squared)
        : squared_(squared) {}

    template <typename Node> bool do_intersect(const Point& p, const Node& node) const {
      double squared = 0.;
      for(int d = 0; d < 3; ++d) {
        const double beyond =
            (std::max)({(node.bbox().min)(d)-p[d], p[d] - (node.bbox().max)(d), 0.});
        squared += beyond * beyond;
      }
      return squared <= squared_;
    }

  protected:
    template <typename Primitive> bool is_near(const Point& p, const Primitive& primitive) const {
      return CGAL::squared_distance(p, *primitive.id()) <= squared_;
    }

  private:
    const double squared_;
  };

  // A search that ends with the first triangle that is near enough, whichever it is. From the axis
  // of a bore all of its wall is equally near, and the nearest triangle takes linear time.
  class Any_within : public Within
  {
  public:
    using Within::Within;

    bool go_further() const { return !is_found; }

    template <typename Primitive> void intersection(const Point& p, const Primitive& primitive) {
      if(this->is_near(p, primitive)) {
        is_found = true;
        found = primitive.id();
      }
    }

    bool is_found = false;
    Primitive_id found;
  };

  // Sums up the normals of the triangles that a point is nearest to in a vertex or on an edge, each
  // as much as its angle there (Baerentzen and Aanaes, Signed distance computation using the angle
  // weighted pseudonormal, 2005): one of them alone may be seen from behind.
  class Normal_around : public Within
  {
  public:
    Normal_around(double squared, const Point& place, double rounding)
        : Within(squared)
        , place_(place)
        , rounding_(rounding) {}

    bool go_further() const { return true; }

    template <typename Primitive> void intersection(const Point& p, const Primitive& primitive) {
      const Triangle& t = *primitive.id();
      if(this->is_near(p, primitive)) {
        const Vector n = Largest_distance::normal(t);
        normal = normal + n * (angle(t) / std::sqrt(n.squared_length()));
      }
    }

    Vector normal = NULL_VECTOR;

  private:
    double angle(const Triangle& t) const {
      for(int i = 0; i < 3; ++i)
        if(CGAL::squared_distance(t[i], place_) <= rounding_) {
          const Vector a = t[i + 1] - t[i], b = t[i + 2] - t[i];
          return arc_tangent(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
        }
      return CGAL_PI;
    }

    const Point place_;
    const double rounding_;
  };

  // Positive above the triangles, negative below.
  double side(const Point& p, const Nearest& nearest) const {
    const double squared = CGAL::squared_distance(p, nearest.first), rounding = 1e-9 * squared;
    const Vector to_point = p - nearest.first, n = normal(*nearest.second);
    const double height = to_point * n;
    if(height * height >= (squared - rounding) * n.squared_length())
      return height; // of the inside of the triangle
    Normal_around around(squared + rounding, nearest.first, rounding);
    tree_.traversal(p, around);
    return to_point * around.normal;
  }

  // Notes which, if there is one. The one that is noted already may do.
  bool has_within(double distance, const Point& p, Primitive_id& found) const {
    if(distance < 0.)
      return false;
    if(CGAL::squared_distance(p, *found) <= distance * distance)
      return true;
    Any_within search(distance * distance);
    tree_.traversal(p, search);
    if(search.is_found)
      found = search.found;
    return search.is_found;
  }

  static double radius_around(const Point& center, const Triangle& t) {
    return std::sqrt(
        (std::max)({CGAL::squared_distance(center, t[0]), CGAL::squared_distance(center, t[1]),
                    CGAL::squared_distance(center, t[2])}));
  }

  static double distance_of_corners(const Triangle& t, const Triangle& other) {
    return std::sqrt(
        (std::max)({CGAL::squared_distance(t[0], other), CGAL::squared_distance(t[1], other),
                    CGAL::squared_distance(t[2], other)}));
  }

  // At the middle of the longest side: needles, of which caps and walls of bores consist, would
  // keep their shape in four parts.
  static void divide(const Triangle& t, Triangles& parts) {
    int longest = 0;
    for(int i = 1; i < 3; ++i)
      if(squared_length_from(t, i) > squared_length_from(t, longest))
        longest = i;
    const Point &p = t[longest], &q = t[longest + 1], &r = t[longest + 2],
                middle = CGAL::midpoint(p, q);
    parts.insert(parts.end(), {{p, middle, r}, {middle, q, r}});
  }

  static double squared_length_from(const Triangle& t, int i) {
    return CGAL::squared_distance(t[i], t[i + 1]);
  }

  const Triangles to_;
  const Accuracy accuracy_;
  Tree tree_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LARGEST_DISTANCE_H
