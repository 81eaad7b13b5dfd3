// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/linking/link.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Linking_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Volume_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Square_root_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/exact_vectors.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

Linking link(Execution execution, const Surface_curves& curves, bool do_link) {
  Linking_numbers numbers(curves);
  if(do_link)
    numbers.link(execution);
  return numbers.take();
}

std::vector<int> signs_of_volumes(
    std::size_t number_of_components,
    const std::function<void(const std::function<void(std::size_t, const Triangle&)>&)>&
        for_each_triangle) {
  std::vector<Volume_sum> sums(number_of_components);
  std::vector<std::optional<double>> planes(number_of_components);
  for_each_triangle([&](std::size_t component, const Triangle& t) {
    std::optional<double>& plane = planes[component];
    if(!plane)
      plane = t[0][2];
    sums[component].add(t, *plane);
  });
  std::vector<int> signs;
  for(const Volume_sum& sum : sums)
    signs.push_back(sum.sign());
  if(std::find(signs.begin(), signs.end(), 0) == signs.end())
    return signs;

  std::vector<Exact_number> volumes(number_of_components);
  for_each_triangle([&](std::size_t component, const Triangle& t) {
    if(signs[component] == 0)
      volumes[component] += dot(exact(t[0]), cross(exact(t[1]), exact(t[2])));
  });
  for(std::size_t i = 0; i < signs.size(); ++i)
    if(signs[i] == 0)
      signs[i] = sign_of(volumes[i]);
  return signs;
}

Seen_triangle see_triangle(const Triangle& t, const Vector& a, const Vector& b) {
  const std::vector<Vector> vertices = {t[0], t[1], t[2], a, b};
  const Projected_points points(vertices, {0., 0.});
  const Projected_points::Point corners[] = {points.vertex(0), points.vertex(1), points.vertex(2)},
                                seen_from = points.midpoint(3, 4);
  const int sense = points.turn(corners[0], corners[1], corners[2]);
  for(int i = 0; i < 3; ++i)
    if(sense == 0 || points.turn_to_moved(corners[i], corners[(i + 1) % 3], seen_from) != sense)
      return Seen_triangle::NOWHERE;
  const int height = points.side(corners[0], corners[1], corners[2], seen_from) * sense;
  return height == 0  ? Seen_triangle::HERE
         : height < 0 ? Seen_triangle::ABOVE
                      : Seen_triangle::BELOW;
}

void sort_positions(Execution execution, std::vector<Edge_position>& positions) {
  sort(execution, positions.begin(), positions.end(), std::less<>());
}

// ---- the growth of loops, see `Offset_classifier`

namespace loop_growth {

constexpr double epsilon = 0x1p-52;

// A point of a loop and the sum of the area vectors of the faces there, with a bound of its error
// if it is computed in floating point.
template <typename FT> struct Edge_point
{
  Vector_of_numbers<FT> point, area;
  double error = 0.;
};

// A value that is off by no more than `error`.
struct Estimate
{
  double value = 0., error = 0.;
};

// A power of two that makes the coordinates along a loop smaller than 1: the growth has no unit,
// and nothing overflows.
static double scale_of(const Loop_with_faces& loop) {
  double largest = 0.;
  for(const Loop_with_faces::Step& step : loop.steps)
    for(const Vector& p : {step.p, step.q})
      for(double x : p)
        largest = (std::max)(largest, std::abs(x));
  return std::ldexp(1., (std::min)(-binary_exponent(largest), 1000));
}

template <typename FT> Vector_of_numbers<FT> scaled(const Vector& p, double scale) {
  return {FT(FT(scale) * FT(p[0])), FT(FT(scale) * FT(p[1])), FT(FT(scale) * FT(p[2]))};
}

// Adds twice the area vector of a face.
template <typename FT>
void add_area(const Triangle& face, double scale, Edge_point<FT>& edge_point) {
  const Vector_of_numbers<FT> a = scaled<FT>(face[0], scale), u = scaled<FT>(face[1], scale) - a,
                              v = scaled<FT>(face[2], scale) - a;
  edge_point.area = edge_point.area + cross(u, v);
  if constexpr(std::is_same<FT, double>::value)
    edge_point.error += epsilon * (8. * std::sqrt(dot(u, u) * dot(v, v)) +
                                   2. * std::sqrt(dot(edge_point.area, edge_point.area)));
}

template <typename FT>
Edge_point<FT> edge_point_of(const Loop_with_faces& loop, std::size_t i, double scale) {
  const Loop_with_faces::Step& step = loop.steps[i];
  Edge_point<FT> edge_point = {{FT(0), FT(0), FT(0)}, {FT(0), FT(0), FT(0)}, 0.};
  if(step.is_vertex) {
    edge_point.point = scaled<FT>(step.ratio == 1. ? step.q : step.p, scale);
  } else {
    const Vector_of_numbers<FT> p = scaled<FT>(step.p, scale), q = scaled<FT>(step.q, scale);
    for(int d = 0; d < 3; ++d)
      edge_point.point[d] = p[d] + FT(step.ratio) * (q[d] - p[d]);
  }
  for(std::size_t f = i == 0 ? 0 : loop.steps[i - 1].end_of_faces; f < step.end_of_faces; ++f)
    add_area(loop.faces[f], scale, edge_point);
  return edge_point;
}

// calls f(sign, edge_point, segment) for the terms of the growth.
template <typename FT, typename Function>
void for_each_term(const Loop_with_faces& loop, const Function& f) {
  if(loop.steps.empty())
    return;
  const double scale = scale_of(loop);
  Edge_point<FT> previous = edge_point_of<FT>(loop, loop.steps.size() - 1, scale);
  for(std::size_t i = 0; i < loop.steps.size(); ++i) {
    Edge_point<FT> next = edge_point_of<FT>(loop, i, scale);
    const Vector_of_numbers<FT> segment = next.point - previous.point;
    f(1, next, segment);
    f(-1, previous, segment);
    previous = std::move(next);
  }
}

// A cosine is off by no more than the directions of its vectors, and these by little more than
// the errors of the vectors over their lengths; the factors are generous.
static Estimate estimate(const Loop_with_faces& loop) {
  Estimate sum;
  for_each_term<double>(
      loop, [&](int sign, const Edge_point<double>& edge_point, const Vector& segment) {
        const double area = norm(edge_point.area), length = norm(segment);
        // No coordinate is larger than 1.
        const double off = 4. * edge_point.error / area + epsilon * (32. + 64. / length);
        // Also if there is no area or no length: no cosine is beyond 1.
        if(!(off < 0.5)) {
          sum.error += 1.;
          return;
        }
        sum.value += sign * dot(edge_point.area, segment) / (area * length);
        sum.error += off;
      });
  sum.error += 4. * epsilon * double(loop.steps.size()) * double(loop.steps.size());
  return sum;
}

static void add_growth(const Loop_with_faces& loop, int factor, Square_root_sum& sum) {
  using Exact_rationals = Vector_of_numbers<Exact_rational>;
  for_each_term<Exact_rational>(loop, [&](int sign, const Edge_point<Exact_rational>& edge_point,
                                          const Exact_rationals& segment) {
    const Exact_rationals& area = edge_point.area;
    const Exact_rational cosine = dot(area, segment);
    if(const int sense = sign_of(cosine))
      sum.add(factor * sign * sense,
              Exact_rational(cosine * cosine / (dot(area, area) * dot(segment, segment))));
  });
}

} // namespace loop_growth

double growth_of(const Loop_with_faces& loop) { return loop_growth::estimate(loop).value; }

double length_at_offset(const Loop_with_faces& loop, double offset) {
  if(loop.steps.empty())
    return 0.;
  const double scale = loop_growth::scale_of(loop);
  const auto moved = [&](std::size_t i) {
    const auto at = loop_growth::edge_point_of<double>(loop, i, scale);
    const double area = norm(at.area);
    Vector result = at.point;
    for(int d = 0; area > 0. && d < 3; ++d)
      result[d] += offset * scale * at.area[d] / area;
    return result;
  };
  Vector previous = moved(loop.steps.size() - 1);
  double sum = 0.;
  for(std::size_t i = 0; i < loop.steps.size(); ++i) {
    const Vector next = moved(i);
    sum += norm(next - previous);
    previous = next;
  }
  return sum / scale;
}

int compare_growth_of(const Loop_with_faces& a, const Loop_with_faces& b) {
  const loop_growth::Estimate x = loop_growth::estimate(a), y = loop_growth::estimate(b);
  const double difference = x.value - y.value;
  if(std::abs(difference) > 2. * (x.error + y.error))
    return difference > 0. ? 1 : -1;
  Square_root_sum sum;
  loop_growth::add_growth(a, 1, sum);
  loop_growth::add_growth(b, -1, sum);
  return sum.sign();
}

} // namespace CGAL::Handle_tunnel_loops::internal
