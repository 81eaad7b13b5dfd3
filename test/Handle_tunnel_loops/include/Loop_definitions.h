#ifndef HTL_TEST_LOOP_DEFINITIONS_H
#define HTL_TEST_LOOP_DEFINITIONS_H

#include "Edge_walks.h"

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// What the results are by definition, checked without the certificate of the package.

using Coordinates = std::array<double, 3>;

template <typename Point> Coordinates coordinates(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

// Without squares that overflow.
inline double distance(const Coordinates& p, const Coordinates& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

template <typename TriangleMesh, typename Loop>
auto faces_at(const TriangleMesh& tm, const typename Loop::Step& step) {
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> faces;
  if(step.ratio > 0. && step.ratio < 1.)
    faces = {face(step.halfedge, tm), face(opposite(step.halfedge, tm), tm)};
  else {
    const auto h = step.ratio == 1. ? step.halfedge : opposite(step.halfedge, tm);
    for(const auto f : CGAL::faces_around_target(h, tm))
      faces.push_back(f);
  }
  return faces;
}

template <typename TriangleMesh, typename Loop>
bool is_closed_on_surface(const TriangleMesh& tm, const Loop& loop) {
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const auto a = faces_at<TriangleMesh, Loop>(tm, loop.steps()[i]);
    const auto b = faces_at<TriangleMesh, Loop>(tm, loop.steps()[(i + 1) % loop.size()]);
    if(std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) == a.end())
      return false;
  }
  return true;
}

// Points and length are those of the steps, up to rounding.
template <typename TriangleMesh, typename VertexPointMap, typename Loop>
void expect_geometry_of_steps(const TriangleMesh& tm, VertexPointMap point, const Loop& loop) {
  ASSERT_EQ(loop.points().size(), loop.size());
  double largest = 0., length = 0.;
  for(const auto& p : loop.points())
    for(const double x : coordinates(p))
      largest = (std::max)(largest, std::abs(x));
  const double rounding = 16. * std::numeric_limits<double>::epsilon() * largest +
                          4. * std::numeric_limits<double>::denorm_min();
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const auto& [h, ratio] = loop.steps()[i];
    const Coordinates p = coordinates(get(point, source(h, tm)));
    const Coordinates q = coordinates(get(point, target(h, tm)));
    Coordinates expected;
    for(int d = 0; d < 3; ++d)
      expected[d] = p[d] + ratio * (q[d] - p[d]);
    const Coordinates actual = coordinates(loop.points()[i]);
    // The ends of the edge may be larger than the point on it.
    EXPECT_LE(distance(actual, expected), rounding + 1e-14 * distance(p, q)) << "step " << i;
    length += distance(actual, coordinates(loop.points()[(i + 1) % loop.size()]));
  }
  EXPECT_NEAR(loop.length(), length, 1e-10 * length + rounding * static_cast<double>(loop.size()));
}

template <typename TriangleMesh, typename VertexPointMap, typename Loop>
void expect_loop(const TriangleMesh& tm, VertexPointMap point, const Loop& loop) {
  ASSERT_GE(loop.size(), 3u);
  for(const auto& step : loop.steps()) {
    ASSERT_TRUE(step.ratio >= 0. && step.ratio <= 1.) << step.ratio;
    EXPECT_EQ(step.is_vertex(), step.ratio == 0. || step.ratio == 1.);
  }
  ASSERT_TRUE(is_closed_on_surface(tm, loop));
  expect_geometry_of_steps(tm, point, loop);
}

// The intersection form of a closed surface is unimodular. Hence curves, as many as twice the
// genus, are a basis of the first homology group over the integers if and only if the matrix of
// their intersection numbers has determinant one.
template <typename TriangleMesh, typename PairRange>
void expect_paired_basis(const TriangleMesh& tm, const PairRange& pairs) {
  std::vector<Edge_walk<TriangleMesh>> walks;
  for(const auto& pair : pairs) {
    walks.push_back(walk_beside(tm, pair.handle()));
    walks.push_back(walk_beside(tm, pair.tunnel()));
  }
  const Integer_matrix matrix = intersection_matrix(tm, walks);
  for(std::size_t i = 0; i < walks.size(); ++i)
    for(std::size_t j = 0; j <= i; ++j)
      ASSERT_EQ(matrix[i][j], -matrix[j][i]) << "the test itself is wrong";
  for(std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_EQ(abs(matrix[2 * k][2 * k + 1]), 1) << "tunnel and handle of pair " << k;
  EXPECT_EQ(determinant(matrix), 1);
}

// All that is promised of the pairs of a surface of the given genus, summed over its components.
template <typename TriangleMesh, typename VertexPointMap, typename PairRange>
void expect_handle_tunnel_pairs(const TriangleMesh& tm,
                                VertexPointMap point,
                                const PairRange& pairs,
                                std::size_t genus) {
  ASSERT_EQ(pairs.size(), genus);
  std::size_t index = 0;
  for(const auto& pair : pairs) {
    for(const CGAL::Loop_type type : {CGAL::Loop_type::HANDLE, CGAL::Loop_type::TUNNEL}) {
      const auto& loop = pair.loop(type);
      SCOPED_TRACE(::testing::Message() << (type == CGAL::Loop_type::HANDLE ? "handle" : "tunnel")
                                        << " loop of pair " << index);
      EXPECT_EQ(&loop, type == CGAL::Loop_type::HANDLE ? &pair.handle() : &pair.tunnel());
      EXPECT_EQ(loop.type(), type);
      EXPECT_EQ(loop.pair_index(), index);
      EXPECT_NE(&pair.partner(loop), &loop);
      EXPECT_EQ(&pair.partner(pair.partner(loop)), &loop);
      expect_loop(tm, point, loop);
    }
    ++index;
  }
  if(!::testing::Test::HasFatalFailure())
    expect_paired_basis(tm, pairs);
}

template <typename TriangleMesh, typename PairRange>
void expect_handle_tunnel_pairs(const TriangleMesh& tm, const PairRange& pairs, std::size_t genus) {
  expect_handle_tunnel_pairs(tm, get(CGAL::vertex_point, tm), pairs, genus);
}

#endif // HTL_TEST_LOOP_DEFINITIONS_H
