// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_LOOP_CONVERTER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_LOOP_CONVERTER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/halfedge_near.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Turns loops on the flat mesh into loops on the caller's mesh, which has no hubs: where a loop
/// crosses an edge to one, it is at the vertex on the boundary. `Vertices` is an array of the
/// caller's vertices, by index in the flat mesh.
template <typename TriangleMesh,
          typename VertexPointMap,
          typename GeomTraits,
          typename Vertices =
              std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>>
class Loop_converter
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using FT = typename GeomTraits::FT;

public:
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Loop = Loop_on_surface<TriangleMesh, Point>;

  Loop_converter(const TriangleMesh& tm,
                 VertexPointMap point,
                 const GeomTraits& traits,
                 const Vertices& vertices)
      : tm_(tm)
      , point_(point)
      , traits_(traits)
      , vertices_(vertices) {}

  Loop operator()(const Crossing_loop& loop, Loop_type type, std::size_t pair_index) const {
    std::vector<typename Loop::Step> steps;
    std::vector<Point> points;
    const Crossing* previous = loop.empty() ? nullptr : &loop.back();
    halfedge_descriptor edge = boost::graph_traits<TriangleMesh>::null_halfedge();
    for(const Crossing& c : loop) {
      edge = edge_of(c, edge);
      // Many edges are passed at one vertex.
      if(vertex_of(c) == no_index || vertex_of(c) != vertex_of(*previous)) {
        steps.push_back(step(c, edge));
        points.push_back(point_at(c));
      }
      previous = &c;
    }
    const double length = length_of(points);
    return Loop(std::move(steps), std::move(points), length, type, pair_index);
  }

private:
  bool is_hub(Index v) const { return v >= vertices_.size(); }

  // The edge that is crossed, on a face of the one that was crossed before; none that leads to a
  // hub.
  halfedge_descriptor edge_of(const Crossing& c, halfedge_descriptor before) const {
    return is_hub(c.left) || is_hub(c.right)
               ? boost::graph_traits<TriangleMesh>::null_halfedge()
               : halfedge_near(before, vertices_[c.left], vertices_[c.right], tm_);
  }

  typename Loop::Step step(const Crossing& c, halfedge_descriptor edge) const {
    if(is_hub(c.left) || is_hub(c.right))
      return {opposite(halfedge(vertices_[vertex_of(c)], tm_), tm_), 0.};
    return {edge, c.ratio};
  }

  Index vertex_of(const Crossing& c) const {
    return is_hub(c.right) || (c.ratio == 0. && !is_hub(c.left)) ? c.left
           : is_hub(c.left) || c.ratio == 1.                     ? c.right
                                                                 : no_index;
  }

  Point point_at(const Crossing& c) const {
    if(vertex_of(c) != no_index)
      return get(point_, vertices_[vertex_of(c)]);
    const auto& p = get(point_, vertices_[c.left]);
    const auto& q = get(point_, vertices_[c.right]);
    if constexpr(std::is_floating_point<FT>::value) { // as below, but with rounded products
      const FT at_p = FT(1. - c.ratio), at_q = FT(c.ratio), sum = at_p + at_q;
      const auto between = [&](FT a, FT b) {
        return (rounded_product(at_p, a) + rounded_product(at_q, b)) / sum;
      };
      return traits_.construct_point_3_object()(between(p.x(), q.x()), between(p.y(), q.y()),
                                                between(p.z(), q.z()));
    } else
      return traits_.construct_barycenter_3_object()(p, 1. - c.ratio, q, c.ratio);
  }

  // Of the points as they are: on the flat mesh, they are rounded to what the largest coordinate
  // leaves of them.
  static double length_of(const std::vector<Point>& points) {
    const auto half = [](const FT& a, const FT& b) {
      if constexpr(std::is_floating_point<FT>::value)
        return half_difference(a, b);
      else
        return CGAL::to_double(FT(a - b)) / 2.;
    };
    double sum = 0.;
    const Point* p = points.empty() ? nullptr : &points.back();
    for(const Point& q : points) {
      const double x = half(q.x(), p->x()), y = half(q.y(), p->y()), z = half(q.z(), p->z());
      const double largest = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
      if(largest > 0.)
        sum += rounded_product(largest, rounded_length(x / largest, y / largest, z / largest));
      p = &q;
    }
    return 2. * sum;
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  const GeomTraits& traits_;
  const Vertices& vertices_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_LOOP_CONVERTER_H
