// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_GROWTH_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_GROWTH_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Square_root_sum.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Computes the growth of loops; see `Offset_classifier`.
class Loop_growth
{
public:
  static double growth(const Loop_with_faces& loop) { return estimate(loop).value; }

  static int compare(const Loop_with_faces& a, const Loop_with_faces& b) {
    const Estimate x = estimate(a), y = estimate(b);
    const double difference = x.value - y.value;
    if(std::abs(difference) > 2. * (x.error + y.error))
      return difference > 0. ? 1 : -1;
    Square_root_sum sum;
    add_growth(a, 1, sum);
    add_growth(b, -1, sum);
    return sum.sign();
  }

  static double length_at_offset(const Loop_with_faces& loop, double offset) {
    if(loop.steps.empty())
      return 0.;
    const double s = scale(loop);
    Vector_of<double> previous = moved(loop, loop.steps.size() - 1, s, offset);
    double sum = 0.;
    for(std::size_t i = 0; i < loop.steps.size(); ++i) {
      const Vector_of<double> next = moved(loop, i, s, offset), segment = minus(next, previous);
      sum += std::sqrt(product(segment, segment));
      previous = next;
    }
    return sum / s;
  }

private:
  using Step = Loop_with_faces::Step;
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
  static double scale(const Loop_with_faces& loop) {
    double largest = 0.;
    for(const Step& step : loop.steps)
      for(const Vector& p : {step.p, step.q})
        for(double x : p)
          largest = (std::max)(largest, std::abs(x));
    int exponent;
    std::frexp(largest, &exponent);
    return std::ldexp(1., (std::min)(-exponent, 1000));
  }

  template <typename FT> static Vector_of<FT> point(const Vector& p, double scale) {
    return {FT(FT(scale) * FT(p[0])), FT(FT(scale) * FT(p[1])), FT(FT(scale) * FT(p[2]))};
  }

  // Adds twice the area vector of a face.
  template <typename FT>
  static void
  add_area(const std::array<Vector, 3>& face, double scale, Edge_point<FT>& edge_point) {
    const Vector_of<FT> a = point<FT>(face[0], scale), u = minus(point<FT>(face[1], scale), a),
                        v = minus(point<FT>(face[2], scale), a);
    for(int d = 0; d < 3; ++d)
      edge_point.area[d] += u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3];
    if constexpr(std::is_same<FT, double>::value)
      edge_point.error += epsilon * (8. * std::sqrt(product(u, u) * product(v, v)) +
                                     2. * std::sqrt(product(edge_point.area, edge_point.area)));
  }

  template <typename FT>
  static Edge_point<FT> edge_point(const Loop_with_faces& loop, std::size_t i, double scale) {
    const Step& step = loop.steps[i];
    Edge_point<FT> edge_point = {{FT(0), FT(0), FT(0)}, {FT(0), FT(0), FT(0)}, 0.};
    if(step.is_vertex) {
      edge_point.point = point<FT>(step.ratio == 1. ? step.q : step.p, scale);
    } else {
      const Vector_of<FT> p = point<FT>(step.p, scale), q = point<FT>(step.q, scale);
      for(int d = 0; d < 3; ++d)
        edge_point.point[d] = p[d] + FT(step.ratio) * (q[d] - p[d]);
    }
    for(std::size_t f = i == 0 ? 0 : loop.steps[i - 1].end_of_faces; f < step.end_of_faces; ++f)
      add_area(loop.faces[f], scale, edge_point);
    return edge_point;
  }

  static Vector_of<double>
  moved(const Loop_with_faces& loop, std::size_t i, double scale, double offset) {
    const Edge_point<double> at = edge_point<double>(loop, i, scale);
    const double area = std::sqrt(product(at.area, at.area));
    Vector_of<double> result = at.point;
    for(int d = 0; area > 0. && d < 3; ++d)
      result[d] += offset * scale * at.area[d] / area;
    return result;
  }

  // calls f(sign, edge_point, segment) for the terms of the growth.
  template <typename FT, typename Function>
  static void for_each_term(const Loop_with_faces& loop, const Function& f) {
    if(loop.steps.empty())
      return;
    const double s = scale(loop);
    Edge_point<FT> previous = edge_point<FT>(loop, loop.steps.size() - 1, s);
    for(std::size_t i = 0; i < loop.steps.size(); ++i) {
      Edge_point<FT> next = edge_point<FT>(loop, i, s);
      const Vector_of<FT> segment = minus(next.point, previous.point);
      f(1, next, segment);
      f(-1, previous, segment);
      previous = std::move(next);
    }
  }

  // A cosine is off by no more than the directions of its vectors, and these by little more than
  // the errors of the vectors over their lengths; the factors are generous.
  static Estimate estimate(const Loop_with_faces& loop) {
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
    sum.error += 4. * epsilon * double(loop.steps.size()) * double(loop.steps.size());
    return sum;
  }

  static void add_growth(const Loop_with_faces& loop, int factor, Square_root_sum& sum) {
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
};

CGAL_HTL_CORE double growth_of(const Loop_with_faces& loop) { return Loop_growth::growth(loop); }

CGAL_HTL_CORE double length_at_offset(const Loop_with_faces& loop, double offset) {
  return Loop_growth::length_at_offset(loop, offset);
}

CGAL_HTL_CORE int compare_growth_of(const Loop_with_faces& a, const Loop_with_faces& b) {
  return Loop_growth::compare(a, b);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_GROWTH_IMPL_H
