// The parts of the linking numbers against what they are by definition: predicates on projected
// points, rectangles that meet, chains.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Linking_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Sparse_matrix.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Exact_rational;
using CGAL::Handle_tunnel_loops::generators::Random;

int sign(const Exact_rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Points with rational coordinates, projected by the definition.
struct By_definition
{
  std::vector<Exact_vector> points;
  Projected_points::Direction direction;

  Exact_vector projected(Index p) const {
    const Exact_vector& v = points[p];
    return {Exact_rational(v[0] - Exact_rational(direction.a) * v[2]),
            Exact_rational(v[1] - Exact_rational(direction.b) * v[2]), Exact_rational(0)};
  }

  int turn(Index p, Index q, Index r) const {
    return sign(cross(projected(q) - projected(p), projected(r) - projected(p))[2]);
  }

  // With r moved by (s, s^2), where s is tiny beside all differences.
  int turn_to_moved(Index p, Index q, Index r, const Exact_rational& s) const {
    const Exact_vector step = {s, Exact_rational(s * s), Exact_rational(0)};
    return sign(cross(projected(q) - projected(p), projected(r) + step - projected(p))[2]);
  }

  int side(Index p, Index q, Index r, Index s) const {
    return sign(dot(cross(points[q] - points[p], points[r] - points[p]), points[s] - points[p]));
  }
};

// Few places, so that many points are at one place, on a line or in a plane.
class Predicates : public testing::TestWithParam<std::pair<double, double>>
{
protected:
  static constexpr Index number_of_vertices = 12, number_of_points = 24;

  void expect_definitions(const std::vector<Vector>& vertices, Random& random) const {
    const auto multiple = [&] { return (static_cast<int>(random.below(9)) - 4) / 4.; };
    const Projected_points::Direction direction = {multiple(), multiple()};
    Projected_points points(vertices, {0.5, -0.25});
    points.see_along(direction);
    By_definition expected{{}, direction};
    for(const Vector& v : vertices)
      expected.points.push_back(Exact_rational(2) * exact(v));
    while(expected.points.size() < number_of_points) {
      const Index u = static_cast<Index>(random.below(number_of_vertices));
      const Index v = static_cast<Index>(random.below(number_of_vertices));
      points.add_midpoint(u, v);
      expected.points.push_back(exact(vertices[u]) + exact(vertices[v]));
    }
    const auto any = [&] { return static_cast<Index>(random.below(number_of_points)); };
    Exact_rational tiny = 1e-300;
    tiny *= tiny * tiny * tiny;
    for(int i = 0; i < 100; ++i) {
      const Index p = any(), q = any(), r = any(), s = any();
      ASSERT_EQ(points.turn(p, q, r), expected.turn(p, q, r));
      ASSERT_EQ(points.turn_to_moved(p, q, r), expected.turn_to_moved(p, q, r, tiny));
      // That the line moves is that the point moves the other way.
      const int moved = points.turn_of_moved(p, q, r);
      ASSERT_EQ(moved, expected.turn(p, q, r) != 0 ? expected.turn(p, q, r)
                                                   : -expected.turn_to_moved(p, q, r, tiny));
      ASSERT_EQ(points.side(p, q, r, s), expected.side(p, q, r, s));
    }
  }
};

// The size of the coordinates and where they are.
INSTANTIATE_TEST_SUITE_P(Sizes,
                         Predicates,
                         testing::Values(std::pair(1., 0.),
                                         std::pair(1e-200, 0.),
                                         std::pair(1e200, 0.),
                                         std::pair(0x1p-40, 1.),
                                         std::pair(1., 1e9),
                                         std::pair(5e-324, 0.),
                                         std::pair(4e307, 0.)));

TEST_P(Predicates, AreExactOnAGrid) {
  const auto [scale, shift] = GetParam();
  Random random(1);
  for(int round = 0; round < 12; ++round) {
    std::vector<Vector> vertices(number_of_vertices);
    for(Vector& v : vertices)
      for(double& x : v)
        x = scale * (static_cast<double>(random.below(5)) - 1.) + shift;
    expect_definitions(vertices, random);
  }
}

TEST_P(Predicates, AreExactNearAGrid) {
  const auto [scale, shift] = GetParam();
  Random random(2);
  for(int round = 0; round < 12; ++round) {
    std::vector<Vector> vertices(number_of_vertices);
    for(Vector& v : vertices)
      for(double& x : v) {
        x = scale * (static_cast<double>(random.below(3)) - 1.) + shift;
        if(random.below(3) == 0)
          x = std::nextafter(x, random.below(2) ? 1. : -1.);
      }
    expect_definitions(vertices, random);
  }
}

TEST(Collinear, IsDecidedExactly) {
  const Vector a = {0.1, 0.2, 0.3}, b = {0.2, 0.4, 0.6};
  EXPECT_TRUE(are_collinear({0., 0., 0.}, a, b));
  EXPECT_FALSE(are_collinear({0., 0., 0.}, a, {0.2, 0.4, std::nextafter(0.6, 1.)}));
  EXPECT_TRUE(are_collinear(a, a, {5., 1., 2.}));
  EXPECT_TRUE(are_collinear({-1e300, 0., 0.}, {1e300, 0., 0.}, {1e-300, 0., 0.}));
  EXPECT_FALSE(are_collinear({-1e300, 0., 0.}, {1e300, 0., 0.}, {1e-300, 1e-300, 0.}));
}

// A line of loop 0 beside an edge of loop 1: over it, under it, short of it, or touching it.
class Line_and_edge : public testing::Test
{
protected:
  // The line leads from (1, y, z) to (1, 1, 0), the edge from (0, 0, 0) to (2, 0, 0).
  void link(double y, double z) {
    Surface_curves curves;
    curves.vertices = {
        {0., 0., 0.}, {2., 0., 0.}, {1., 1., 1.}, {1., 2. * y - 1., 2. * z - 1.}, {1., 1., -1.}};
    curves.edges = {{0, 1, 2, 4}};
    curves.corners = {{2, 3, 4, 0}};
    curves.walks.add(0, 1, 1);
    curves.walks.finish(1);
    curves.crossings.finish(1);
    curves.outward = {1, 1};
    Linking_numbers numbers(curves);
    numbers.link(Execution());
    contacts = numbers.contacts().size();
    value = numbers.linking().empty() ? 0 : numbers.linking().front().value;
  }

  std::size_t contacts = 0;
  std::int64_t value = 0;
};

constexpr double smallest_step = 0x1p-53;

TEST_F(Line_and_edge, TouchAtTheEnd) {
  link(0., 0.);
  EXPECT_EQ(contacts, 1u);
}

TEST_F(Line_and_edge, TouchWithin) {
  link(-1., 0.);
  EXPECT_EQ(contacts, 1u);
  link(-smallest_step, 0.);
  EXPECT_EQ(contacts, 1u);
}

TEST_F(Line_and_edge, MayEndShortOfEachOther) {
  link(smallest_step, 0.);
  EXPECT_EQ(contacts, 0u);
  EXPECT_EQ(value, 0);
}

// Only one of the two counts: the line is seen above the edge, if it is seen to cross it.
TEST_F(Line_and_edge, MayPassEachOther) {
  link(-1., -1.);
  EXPECT_EQ(contacts, 0u);
  EXPECT_EQ(value, 0);
  link(-1., 1.);
  EXPECT_EQ(contacts, 0u);
  const std::int64_t above = value;
  EXPECT_EQ(above, -1);
  link(-1., smallest_step);
  EXPECT_EQ(contacts, 0u);
  EXPECT_EQ(value, above);
  link(-1., -smallest_step);
  EXPECT_EQ(contacts, 0u);
  EXPECT_EQ(value, 0);
}

TEST(Boxes, AreFoundWhereTheyMeet) {
  Random random(3);
  for(int round = 0; round < 50; ++round) {
    const auto random_box = [&] {
      const double x = static_cast<double>(random.below(20)),
                   y = static_cast<double>(random.below(20));
      return Box{x, y, x + static_cast<double>(random.below(4)),
                 y + static_cast<double>(random.below(4))};
    };
    std::vector<Box> boxes(random.below(100));
    for(Box& b : boxes)
      b = random_box();
    const Box_tree tree(boxes);
    for(int i = 0; i < 20; ++i) {
      const Box box = random_box();
      std::set<Index> found, expected;
      tree.for_each_meeting(box, [&](Index j, const Box& b) {
        EXPECT_EQ(b.xmin, boxes[j].xmin);
        EXPECT_TRUE(found.insert(j).second) << "found twice";
      });
      for(Index j = 0; j < boxes.size(); ++j)
        if(boxes[j].meets(box))
          expected.insert(j);
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(Chains_of_loops, AddUp) {
  Random random(4);
  for(int round = 0; round < 50; ++round) {
    const std::size_t elements = 1 + random.below(10);
    Chains chains;
    std::map<std::pair<Index, Index>, int> expected;
    for(Index loop = 0; loop < 5; ++loop)
      for(std::size_t i = random.below(20); i > 0; --i) {
        const Index element = static_cast<Index>(random.below(elements));
        const int value = random.below(2) ? 1 : -1;
        chains.add(element, loop, value);
        expected[{element, loop}] += value;
      }
    chains.finish(elements);
    std::map<std::pair<Index, Index>, int> found;
    for(Index element = 0; element < elements; ++element)
      for(const Chains::Term& t : chains.of(element)) {
        EXPECT_NE(t.value, 0);
        EXPECT_TRUE(found.emplace(std::pair(element, t.loop), t.value).second);
      }
    for(auto it = expected.begin(); it != expected.end();)
      it = it->second == 0 ? expected.erase(it) : std::next(it);
    EXPECT_EQ(found, expected);
  }
}

TEST(Matrix, AddsUpWhatIsAtOnePlace) {
  Sparse_matrix matrix = {{1, 2, 3}, {0, 5, 1}, {1, 2, -1}, {4, 4, 7}, {4, 4, -7}, {1, 0, 2}};
  add_up(matrix);
  ASSERT_EQ(matrix.size(), 3u);
  EXPECT_TRUE(matrix[0].row == 0 && matrix[0].column == 5 && matrix[0].value == 1);
  EXPECT_TRUE(matrix[1].row == 1 && matrix[1].column == 0 && matrix[1].value == 2);
  EXPECT_TRUE(matrix[2].row == 1 && matrix[2].column == 2 && matrix[2].value == 2);
}

} // namespace
