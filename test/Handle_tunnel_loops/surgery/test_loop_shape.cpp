#include "Random_rotations.h"

#include "generators/Random.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/Loop_shape.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_loop_shape {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Direction = Kernel::Vector_3;
using Random = CGAL::Handle_tunnel_loops::generators::Random;

std::vector<Point> polygon(int sides, double radius) {
  std::vector<Point> points;
  for(int i = 0; i < sides; ++i) {
    const double angle = 2. * CGAL_PI * i / sides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.);
  }
  return points;
}

// With points on the sides, which are no corners.
std::vector<Point> divided(const std::vector<Point>& points, int parts) {
  std::vector<Point> all;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()];
    for(int k = 0; k < parts; ++k)
      all.push_back(p + (q - p) * (double(k * k) / (parts * parts)));
  }
  return all;
}

struct Move
{
  random_surfaces::Rotation rotation;
  double scale;
  Direction shift;

  Direction turned(const Direction& v) const {
    const auto row = [&](std::size_t i) {
      return rotation[i][0] * v.x() + rotation[i][1] * v.y() + rotation[i][2] * v.z();
    };
    return {row(0), row(1), row(2)};
  }
  Point operator()(const Point& p) const {
    return CGAL::ORIGIN + scale * (turned(p - CGAL::ORIGIN) + shift);
  }
};

Move random_move(unsigned seed, double scale) {
  Random random(seed);
  const auto rotation = random_surfaces::random_rotation(random);
  const auto number = [&] { return random.uniform(-3., 3.); };
  const double x = number(), y = number(), z = number();
  return {rotation, scale, Direction(x, y, z)};
}

TEST(Loop_shape, OfCirclesIsExact) {
  for(const int sides : {6, 7, 12, 100}) {
    const auto shape = CGAL::loop_shape(divided(polygon(sides, 2.), 3));
    SCOPED_TRACE(sides);
    EXPECT_NEAR(shape.length, 4. * sides * std::sin(CGAL_PI / sides), 1e-12);
    EXPECT_NEAR(shape.diameter, shape.length / CGAL_PI, 1e-12);
    ASSERT_TRUE(shape.circle);
    EXPECT_NEAR(shape.circle->diameter, 4., 1e-12);
    EXPECT_NEAR(shape.circle->deviation, 0., 1e-12);
    EXPECT_NEAR(CGAL::squared_distance(shape.circle->center, Point(0., 0., 0.)), 0., 1e-24);
    EXPECT_NEAR(shape.normal.z(), 1., 1e-12); // it turns counterclockwise
    EXPECT_EQ(shape.deviation, 0.);
    EXPECT_DOUBLE_EQ(shape.box.xmax(), 2.);
  }
}

TEST(Loop_shape, OfOthersHasNoCircle) {
  EXPECT_FALSE(CGAL::loop_shape(polygon(4, 1.)).circle);
  EXPECT_FALSE(CGAL::loop_shape(polygon(5, 1.)).circle);
  EXPECT_FALSE(CGAL::loop_shape(divided(polygon(4, 1.), 9)).circle);
  std::vector<Point> half = polygon(40, 1.);
  half.resize(21);
  EXPECT_FALSE(CGAL::loop_shape(half).circle);
  std::vector<Point> twice = polygon(40, 1.);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 40);
  EXPECT_FALSE(CGAL::loop_shape(twice).circle);
  std::vector<Point> saddle = polygon(40, 1.);
  for(Point& p : saddle)
    p = Point(p.x(), p.y(), 0.1 * (p.x() * p.x() - p.y() * p.y()));
  const auto shape = CGAL::loop_shape(saddle);
  EXPECT_FALSE(shape.circle);
  EXPECT_NEAR(shape.deviation, 0.1, 1e-12);
}

// However it is divided. The corners of polygons with more than five sides are on it.
TEST(Loop_shape, OfOthersHasABestCircle) {
  for(const int parts : {1, 9}) {
    const auto square = CGAL::loop_shape(divided(polygon(4, 1.), parts)).best_circle;
    ASSERT_TRUE(square);
    const double mean = std::sqrt(0.5) * (std::sqrt(2.) + std::asinh(1.)) / 2.;
    EXPECT_NEAR(square->diameter, 2. * mean, 1e-5);
    EXPECT_NEAR(square->out_of_roundness, (1. - std::sqrt(0.5)) / (2. * mean), 1e-5);
    std::vector<Point> ellipse = polygon(60, 1.);
    for(Point& p : ellipse)
      p = Point(1.1 * p.x(), 0.9 * p.y(), 0.);
    const auto shape = CGAL::loop_shape(divided(ellipse, parts));
    EXPECT_FALSE(shape.circle);
    EXPECT_NEAR(shape.best_circle->diameter, 2., 0.02);
    EXPECT_NEAR(shape.best_circle->out_of_roundness, 0.1, 2e-3);
    const auto round = CGAL::loop_shape(divided(polygon(7, 1.), parts)).best_circle;
    EXPECT_NEAR(round->diameter, 2., 1e-12);
    EXPECT_NEAR(round->out_of_roundness, 0., 1e-12);
  }
  std::vector<Point> bent; // a slot that goes along a third of a circle, and is no part of that
  for(const double radius : {10.5, 9.5})
    for(int i = 0; i <= 40; ++i) {
      const double angle = (radius > 10. ? i : 40 - i) * CGAL_PI / 60.;
      bent.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.);
    }
  EXPECT_GT(CGAL::loop_shape(bent).best_circle->out_of_roundness, 0.4);
}

// A square with an uneven sampling: the centroid is that of the line, not of the points.
TEST(Loop_shape, IsThatOfTheLineNotOfItsPoints) {
  const auto shape = CGAL::loop_shape(divided(polygon(4, 1.), 20));
  EXPECT_NEAR(shape.length, 4. * std::sqrt(2.), 1e-12);
  EXPECT_NEAR(CGAL::squared_distance(shape.center, Point(0., 0., 0.)), 0., 1e-24);
  EXPECT_NEAR(std::abs(shape.normal.z()), 1., 1e-12);
}

TEST(Loop_shape, OfPointsAndSegmentsIsDefined) {
  const auto point = CGAL::loop_shape(std::vector<Point>{{1., 2., 3.}});
  EXPECT_EQ(point.length, 0.);
  EXPECT_EQ(point.normal, Direction(CGAL::NULL_VECTOR));
  EXPECT_EQ(point.center, Point(1., 2., 3.));
  const auto segment = CGAL::loop_shape(std::array<Point, 2>{Point(0., 0., 0.), Point(1., 1., 1.)});
  EXPECT_DOUBLE_EQ(segment.length, 2. * std::sqrt(3.));
  EXPECT_NEAR(segment.normal.squared_length(), 1., 1e-12);
  EXPECT_NEAR(segment.deviation, 0., 1e-12);
  EXPECT_FALSE(segment.circle);
}

// Turned, moved, in another unit, begun elsewhere, and the other way around.
TEST(Loop_shape, MovesWithTheLine) {
  for(unsigned seed = 0; seed < 40; ++seed) {
    Random random(seed);
    std::vector<Point> points = divided(polygon(6 + static_cast<int>(seed), 1.), 2);
    for(Point& p : points)
      p = p + Direction(0., 0., random.uniform(-5e-3, 5e-3));
    const auto shape = CGAL::loop_shape(points);
    const double scale = std::pow(10., static_cast<double>(seed % 8 * 40) - 140.);
    const Move move = random_move(seed, scale);
    std::vector<Point> moved;
    for(const Point& p : points)
      moved.push_back(move(p));
    std::rotate(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(seed % points.size()),
                moved.end());
    const auto other = CGAL::loop_shape(moved);
    SCOPED_TRACE(seed);
    EXPECT_NEAR(other.length / scale, shape.length, 1e-9);
    EXPECT_NEAR(other.deviation / scale, shape.deviation, 1e-9);
    EXPECT_NEAR(other.normal * move.turned(shape.normal), 1., 1e-9);
    ASSERT_TRUE(shape.circle && other.circle);
    EXPECT_NEAR(other.circle->diameter / scale, shape.circle->diameter, 1e-9);
    std::reverse(moved.begin(), moved.end());
    EXPECT_NEAR(CGAL::loop_shape(moved).normal * other.normal, -1., 1e-9);
  }
}

// A circle with noise of a thousandth of its radius.
TEST(Loop_shape, OfNoisyCirclesIsNear) {
  Random random(1);
  std::vector<Point> points = polygon(200, 1.);
  const auto noise = [&] { return random.uniform(-1e-3, 1e-3); };
  for(Point& p : points) {
    const double x = noise(), y = noise(), z = noise();
    p = p + Direction(x, y, z);
  }
  const auto shape = CGAL::loop_shape(points);
  ASSERT_TRUE(shape.circle);
  EXPECT_NEAR(shape.circle->diameter, 2., 1e-3);
  EXPECT_LT(shape.circle->deviation, 3e-3);
  EXPECT_LT(shape.deviation, 2e-3);
}

TEST(Loop_shape, TakesPointsOfOtherKernels) {
  using Other = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Other> points;
  for(const Point& p : polygon(8, 1.))
    points.emplace_back(p.x(), p.y(), p.z());
  const CGAL::Handle_tunnel_loops::Loop_shape<Other> shape = CGAL::loop_shape(points);
  ASSERT_TRUE(shape.circle);
  EXPECT_NEAR(shape.circle->diameter, 2., 1e-12);
}

} // namespace test_loop_shape
