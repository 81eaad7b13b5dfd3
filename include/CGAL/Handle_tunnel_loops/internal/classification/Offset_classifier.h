// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSIFICATION_OFFSET_CLASSIFIER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSIFICATION_OFFSET_CLASSIFIER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classification/Square_root_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_walker.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Tells handle loops from tunnel loops by the change of their length when they are moved outwards
(paper, 4.5): handle loops grow, tunnel loops shrink. What is compared is the growth, the derivative
of the length by the offset along the normals: it has no unit and is 2 pi for a circle around a
solid tube.

The normal at a point is the sum of the normals of the faces that contain it, weighted by area, and
scaled to length one; the point is the one at the exact ratio on its edge. Thus the growth is a sum
of square roots of rational numbers: a segment e from a point with area vector M to one with N
contributes N e / (|N| |e|) - M e / (|M| |e|). It is computed in floating point with
a bound of the error first, and where that does not decide a comparison, the sign of the sum is
computed exactly.
*/
template <typename TriangleMesh, typename VertexPointMap> class Offset_classifier
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  Offset_classifier(const TriangleMesh& tm, VertexPointMap point)
      : tm_(tm)
      , point_(point) {}

  /// the derivative of the length of a loop by the way that it is moved along the normals, to which
  /// the faces look.
  template <typename Loop> double growth(const Loop& loop) const { return estimate(loop).value; }

  /// 1 if loop a grows by more than loop b, -1 if by less, 0 if by as much.
  template <typename Loop> int compare_growth(const Loop& a, const Loop& b) const {
    const Estimate x = estimate(a), y = estimate(b);
    const double difference = x.value - y.value;
    if(std::abs(difference) > 2. * (x.error + y.error))
      return difference > 0. ? 1 : -1;
    Square_root_sum sum;
    add_growth(a, 1, sum);
    add_growth(b, -1, sum);
    return sum.sign();
  }

private:
  template <typename FT> using Vector_of = std::array<FT, 3>;

  static constexpr double epsilon = 0x1p-52;

  // A point of a loop and the sum of the area vectors of the faces there, with a bound of its error
  // if it is computed in floating point.
  template <typename FT> struct Edge_point
  {
    Vector_of<FT> point, area;
    double error = 0.;
  };

  // A value that is off by no more than `error`.
  struct Estimate
  {
    double value = 0., error = 0.;
  };

  template <typename FT>
  static Vector_of<FT> minus(const Vector_of<FT>& a, const Vector_of<FT>& b) {
    return {FT(a[0] - b[0]), FT(a[1] - b[1]), FT(a[2] - b[2])};
  }
  template <typename FT> static FT product(const Vector_of<FT>& a, const Vector_of<FT>& b) {
    return FT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
  }

  // A power of two that makes the coordinates along a loop smaller than 1: the growth has no unit,
  // and nothing overflows.
  template <typename Loop> double scale(const Loop& loop) const {
    double largest = 0.;
    for(const auto& step : loop.steps())
      for(vertex_descriptor v : {source(step.halfedge, tm_), target(step.halfedge, tm_)})
        for(double x : coordinates(point_, v))
          largest = (std::max)(largest, std::abs(x));
    int exponent;
    std::frexp(largest, &exponent);
    return std::ldexp(1., (std::min)(-exponent, 1000));
  }

  template <typename FT> Vector_of<FT> point(vertex_descriptor v, double scale) const {
    const Vector p = coordinates(point_, v);
    return {FT(FT(scale) * FT(p[0])), FT(FT(scale) * FT(p[1])), FT(FT(scale) * FT(p[2]))};
  }

  // Adds twice the area vector of the face of h.
  template <typename FT>
  void add_area(halfedge_descriptor h, double scale, Edge_point<FT>& edge_point) const {
    const Vector_of<FT> a = point<FT>(source(h, tm_), scale),
                        u = minus(point<FT>(target(h, tm_), scale), a),
                        v = minus(point<FT>(target(next(h, tm_), tm_), scale), a);
    for(int d = 0; d < 3; ++d)
      edge_point.area[d] += u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3];
    if constexpr(std::is_same<FT, double>::value)
      edge_point.error += epsilon * (8. * std::sqrt(product(u, u) * product(v, v)) +
                                     2. * std::sqrt(product(edge_point.area, edge_point.area)));
  }

  template <typename FT, typename Step>
  Edge_point<FT> edge_point(const Step& step, double scale) const {
    Edge_point<FT> edge_point = {{FT(0), FT(0), FT(0)}, {FT(0), FT(0), FT(0)}, 0.};
    if(step.is_vertex()) {
      const vertex_descriptor v =
          step.ratio == 1. ? target(step.halfedge, tm_) : source(step.halfedge, tm_);
      edge_point.point = point<FT>(v, scale);
      for(halfedge_descriptor h : halfedges_around_source(v, tm_))
        add_area(h, scale, edge_point);
      return edge_point;
    }
    const Vector_of<FT> p = point<FT>(source(step.halfedge, tm_), scale),
                        q = point<FT>(target(step.halfedge, tm_), scale);
    for(int d = 0; d < 3; ++d)
      edge_point.point[d] = p[d] + FT(step.ratio) * (q[d] - p[d]);
    add_area(step.halfedge, scale, edge_point);
    add_area(opposite(step.halfedge, tm_), scale, edge_point);
    return edge_point;
  }

  // calls f(sign, edge_point, segment) for the terms of the growth.
  template <typename FT, typename Loop, typename Function>
  void for_each_term(const Loop& loop, const Function& f) const {
    const auto& steps = loop.steps();
    if(steps.empty())
      return;
    const double s = scale(loop);
    Edge_point<FT> previous = edge_point<FT>(steps.back(), s);
    for(const auto& step : steps) {
      Edge_point<FT> next = edge_point<FT>(step, s);
      const Vector_of<FT> segment = minus(next.point, previous.point);
      f(1, next, segment);
      f(-1, previous, segment);
      previous = std::move(next);
    }
  }

  // A cosine is off by no more than the directions of its vectors, and these by little more than
  // the errors of the vectors over their lengths; the factors are generous.
  template <typename Loop> Estimate estimate(const Loop& loop) const {
    Estimate sum;
    for_each_term<double>(loop, [&](int sign, const Edge_point<double>& edge_point,
                                    const Vector_of<double>& segment) {
      const double area = std::sqrt(product(edge_point.area, edge_point.area)),
                   length = std::sqrt(product(segment, segment));
      // No coordinate is larger than 1.
      const double off = 4. * edge_point.error / area + epsilon * (32. + 64. / length);
      // Also if there is no area or no length: no cosine is beyond 1.
      if(!(off < 0.5)) {
        sum.error += 1.;
        return;
      }
      sum.value += sign * product(edge_point.area, segment) / (area * length);
      sum.error += off;
    });
    sum.error += 4. * epsilon * double(loop.size()) * double(loop.size());
    return sum;
  }

  template <typename Loop>
  void add_growth(const Loop& loop, int factor, Square_root_sum& sum) const {
    for_each_term<Exact_rational>(loop, [&](int sign, const Edge_point<Exact_rational>& edge_point,
                                            const Vector_of<Exact_rational>& segment) {
      const Vector_of<Exact_rational>& area = edge_point.area;
      const Exact_rational cosine = product(area, segment);
      if(cosine == 0)
        return;
      sum.add(factor * sign * (cosine > 0 ? 1 : -1),
              Exact_rational(cosine * cosine / (product(area, area) * product(segment, segment))));
    });
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSIFICATION_OFFSET_CLASSIFIER_H
