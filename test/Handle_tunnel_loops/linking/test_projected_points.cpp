// The parts of the linking numbers against what they are by definition: predicates on projected
// points, rectangles that meet, chains.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Linking_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/are_collinear.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_projected_points {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Exact_rational;
using CGAL::Handle_tunnel_loops::generators::Random;
using CGAL::Handle_tunnel_loops::internal::Vector;

using Rational_vector = Vector_of_numbers<Exact_rational>;

Rational_vector rational(const Vector& v) {
  return {Exact_rational(v[0]), Exact_rational(v[1]), Exact_rational(v[2])};
}

int sign(const Exact_rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Points with rational coordinates, projected by the definition.
struct By_definition
{
  std::vector<Rational_vector> points;
  Projected_points::Direction direction;

  Rational_vector projected(Index p) const {
    const Rational_vector& v = points[p];
    return {Exact_rational(v[0] - Exact_rational(direction.a) * v[2]),
            Exact_rational(v[1] - Exact_rational(direction.b) * v[2]), Exact_rational(0)};
  }

  int turn(Index p, Index q, Index r) const {
    return sign(cross(projected(q) - projected(p), projected(r) - projected(p))[2]);
  }

  // With r moved by (s, s^2), where s is tiny beside all differences.
  int turn_to_moved(Index p, Index q, Index r, const Exact_rational& s) const {
    const Rational_vector step = {s, Exact_rational(s * s), Exact_rational(0)};
    return sign(cross(projected(q) - projected(p), projected(r) + step - projected(p))[2]);
  }

  int side(Index p, Index q, Index r, Index s) const {
    return sign(dot(cross(points[q] - points[p], points[r] - points[p]), points[s] - points[p]));
  }
};

// Few places, so that many points are at one place, on a line or in a plane.
class Definitions : public testing::Test
{
protected:
  static constexpr Index number_of_vertices = 12, number_of_points = 24;

  void expect_definitions(const std::vector<Vector>& vertices, Random& random) const {
    const auto multiple = [&] { return (static_cast<int>(random.below(9)) - 4) / 4.; };
    const Projected_points::Direction direction = {multiple(), multiple()};
    Projected_points seen(vertices, {0.5, -0.25});
    seen.see_along(direction);
    By_definition expected{{}, direction};
    std::vector<Projected_points::Point> points;
    for(Index v = 0; v < number_of_vertices; ++v) {
      points.push_back(seen.vertex(v));
      expected.points.push_back(rational(vertices[v]) + rational(vertices[v]));
    }
    while(expected.points.size() < number_of_points) {
      const Index u = static_cast<Index>(random.below(number_of_vertices));
      const Index v = static_cast<Index>(random.below(number_of_vertices));
      points.push_back(seen.midpoint(u, v));
      expected.points.push_back(rational(vertices[u]) + rational(vertices[v]));
    }
    const auto any = [&] { return static_cast<Index>(random.below(number_of_points)); };
    Exact_rational tiny = 1e-300;
    tiny *= tiny * tiny * tiny;
    for(int i = 0; i < 100; ++i) {
      const Index p = any(), q = any(), r = any(), s = any();
      const auto &a = points[p], &b = points[q], &c = points[r], &d = points[s];
      ASSERT_EQ(seen.turn(a, b, c), expected.turn(p, q, r));
      ASSERT_EQ(seen.turn_to_moved(a, b, c), expected.turn_to_moved(p, q, r, tiny));
      // That the line moves is that the point moves the other way.
      const int moved = seen.turn_of_moved(a, b, c);
      ASSERT_EQ(moved, expected.turn(p, q, r) != 0 ? expected.turn(p, q, r)
                                                   : -expected.turn_to_moved(p, q, r, tiny));
      ASSERT_EQ(seen.side(a, b, c, d), expected.side(p, q, r, s));
    }
  }
};

class Predicates : public Definitions, public testing::WithParamInterface<std::pair<double, double>>
{};

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

// One axis of another scale, and some points far away: what is near must be seen all the same.
TEST_F(Definitions, HoldAtManyScales) {
  Random random(3);
  for(int round = 0; round < 100; ++round) {
    Vector scales;
    for(double& s : scales)
      s = std::ldexp(1., static_cast<int>(random.below(3)) * 300 - 300);
    std::vector<Vector> vertices(number_of_vertices);
    for(Vector& v : vertices) {
      const bool is_far = random.below(4) == 0;
      for(int d = 0; d < 3; ++d)
        v[d] = scales[d] * (static_cast<double>(random.below(5)) - 1.) *
               (is_far ? std::ldexp(1., static_cast<int>(random.below(300))) : 1.);
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

Linking linking_of(const Surface_curves& curves) {
  Linking_numbers numbers(curves);
  numbers.link(Execution());
  return numbers.take();
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
    curves.walks.finish(Execution(), 1);
    curves.crossings.finish(Execution(), 1);
    curves.outward = {1, 1};
    const Linking found = linking_of(curves);
    contacts = found.contacts.size();
    value = found.linking.empty() ? 0 : found.linking.front().value;
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

// ---- closed polygons: what they are seen as must not matter

// The direction along which linking numbers are counted first. If that changes, the polygons below
// are as good as any, but few of their corners are seen on lines.
Projected_points::Direction first_direction() {
  std::minstd_rand random;
  const auto next = [&random] { return (static_cast<int>(random() % 1024) * 2 - 1023) / 1024.; };
  const double a = next();
  return {a, next()};
}

using Lattice_point = std::array<std::int64_t, 3>;
using Lattice_polygon = std::vector<Lattice_point>;

// Two segments between points of a lattice, by integers: as seen along a direction in which no
// point is seen on a line that it is not on.
class Two_segments
{
public:
  Two_segments(const Lattice_point& a,
               const Lattice_point& b,
               const Lattice_point& p,
               const Lattice_point& q)
      : a_(a)
      , b_(b)
      , p_(p)
      , q_(q)
      , turns_{turn(a, b, p), turn(a, b, q), turn(p, q, a), turn(p, q, b)} {}

  // Positive where r turns to the left seen from above.
  static std::int64_t turn(const Lattice_point& p, const Lattice_point& q, const Lattice_point& r) {
    const auto x = [](const Lattice_point& v) { return 1000003 * v[0] - 414217 * v[2]; };
    const auto y = [](const Lattice_point& v) { return 1000003 * v[1] - 732051 * v[2]; };
    return (x(q) - x(p)) * (y(r) - y(p)) - (x(r) - x(p)) * (y(q) - y(p));
  }

  bool meet() const {
    if(volume() != 0)
      return false;
    if(turns_ == std::array<std::int64_t, 4>{0, 0, 0, 0})
      return is_between(a_, p_, q_) || is_between(b_, p_, q_) || is_between(p_, a_, b_) ||
             is_between(q_, a_, b_);
    return is_apart(turns_[0], turns_[1]) && is_apart(turns_[2], turns_[3]);
  }

  // 0 unless the first passes over the second; 1 if that then leads to the left.
  int passage() const {
    if(!is_apart(turns_[0], turns_[1]) || !is_apart(turns_[2], turns_[3]) || volume() == 0)
      return 0;
    const int sense = turns_[1] > 0 ? 1 : -1;
    return (volume() > 0 ? 1 : -1) == sense ? sense : 0;
  }

  // Whether they are in a plane that is seen as a line along (0, 0, 1).
  bool are_seen_on_a_line() const {
    const auto turn = [](const Lattice_point& p, const Lattice_point& q, const Lattice_point& r) {
      return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
    };
    return turn(a_, b_, p_) == 0 && turn(a_, b_, q_) == 0 && turn(p_, q_, a_) == 0 &&
           turn(p_, q_, b_) == 0;
  }

private:
  static bool is_apart(std::int64_t a, std::int64_t b) {
    return (a <= 0 || b <= 0) && (a >= 0 || b >= 0);
  }

  static bool is_between(const Lattice_point& r, const Lattice_point& p, const Lattice_point& q) {
    std::int64_t sum = 0;
    for(int d = 0; d < 3; ++d)
      sum += (p[d] - r[d]) * (q[d] - r[d]);
    return sum <= 0;
  }

  // Positive if q lies above the plane through a, b and p, where these turn to the left.
  std::int64_t volume() const {
    std::int64_t u[3], v[3], w[3];
    for(int d = 0; d < 3; ++d) {
      u[d] = b_[d] - a_[d];
      v[d] = p_[d] - a_[d];
      w[d] = q_[d] - a_[d];
    }
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
  }

  Lattice_point a_, b_, p_, q_;
  std::array<std::int64_t, 4> turns_;
};

// Loop 0 runs along the first polygon, as a copy across corners, loop 1 along the second.
class Two_polygons : public testing::Test
{
protected:
  // The lattice is inclined, so that many of its points are seen at one place.
  static Vector inclined(const Lattice_point& p, double scale) {
    const auto [a, b] = first_direction();
    return {scale * (double(p[0]) + a * double(p[2])), scale * (double(p[1]) + b * double(p[2])),
            scale * double(p[2])};
  }

  static Lattice_polygon random_polygon(Random& random, std::size_t size) {
    Lattice_polygon polygon;
    while(polygon.size() < size) {
      Lattice_point p;
      for(std::int64_t& x : p)
        x = static_cast<std::int64_t>(random.below(size));
      if(polygon.empty() ||
         (p != polygon.back() && (polygon.size() + 1 < size || p != polygon.front())))
        polygon.push_back(p);
    }
    return polygon;
  }

  void link(const Lattice_polygon& copy, const Lattice_polygon& walk, double scale) {
    Surface_curves curves;
    curves.vertices.push_back({0., 0., 0.});
    for(const Lattice_point& p : walk)
      curves.vertices.push_back(inclined(p, scale));
    for(const Lattice_point& p : copy)
      curves.vertices.push_back(inclined(p, 2. * scale)); // the midpoint with the origin counts
    const Index n = static_cast<Index>(walk.size()), m = static_cast<Index>(copy.size());
    for(Index e = 0; e < n; ++e) {
      curves.edges.push_back({1 + e, 1 + (e + 1) % n, 0, 0});
      curves.walks.add(e, 1, 1);
    }
    for(Index c = 0; c < m; ++c)
      curves.corners.push_back({0, 1 + n + c, 1 + n + (c + 1) % m, 0});
    curves.walks.finish(Execution(), n);
    curves.crossings.finish(Execution(), n);
    curves.outward = {1, 1};
    const Linking found = linking_of(curves);
    for(const Contact& contact : found.contacts)
      contacts.emplace(contact.corner, contact.edge);
    for(const Matrix_entry& e : found.linking)
      value += e.value;
  }

  std::set<std::pair<std::size_t, std::size_t>> contacts;
  std::int64_t value = 0;
};

TEST_F(Two_polygons, AreLinkedAsByDefinition) {
  Random random(5);
  int linked = 0, apart = 0, touching = 0;
  for(int round = 0; round < 4000; ++round) {
    contacts.clear();
    value = 0;
    const Lattice_polygon copy = random_polygon(random, 3 + random.below(5)),
                          walk = random_polygon(random, 3 + random.below(5));
    const double scale = std::ldexp(1., static_cast<int>(random.below(3)) * 60 - 60);
    link(copy, walk, scale);
    std::int64_t expected = 0;
    for(std::size_t c = 0; c < copy.size(); ++c)
      for(std::size_t e = 0; e < walk.size(); ++e) {
        const Two_segments segments(copy[c], copy[(c + 1) % copy.size()], walk[e],
                                    walk[(e + 1) % walk.size()]);
        expected += segments.passage();
        const bool is_contact = contacts.count({c, e}) != 0;
        // If the plane that they are in is seen as a line, it need not be known that they are
        // apart.
        EXPECT_TRUE(is_contact == segments.meet() || (is_contact && segments.are_seen_on_a_line()))
            << "round " << round << ", line " << c << ", edge " << e;
      }
    if(contacts.empty()) {
      EXPECT_EQ(value, expected) << "round " << round;
      linked += expected != 0;
      ++apart;
    } else
      ++touching;
  }
  EXPECT_GT(linked, 100);
  EXPECT_GT(apart, 1000);
  EXPECT_GT(touching, 1000);
}

// A path of two edges along x whose middle is seen exactly on the line from (1, -1, 0) to (1, 1,
// 0).
class Line_and_path : public Two_polygons
{
protected:
  void link_at_height(std::int64_t z) {
    const Lattice_polygon line = {{1, -1, 0}, {1, 1, 0}, {9, 0, 0}};
    link(line, {{0, 0, z}, {1, 0, z}, {2, 0, z}, {1, 0, 9}}, 1.);
  }
};

TEST_F(Line_and_path, TouchAtTheEndOfTheEdges) {
  link_at_height(0);
  EXPECT_EQ(contacts, (std::set<std::pair<std::size_t, std::size_t>>{{0, 0}, {0, 1}}));
}

TEST_F(Line_and_path, CrossOnceWhereTheEndOfTheEdgesIsSeenOnTheLine) {
  link_at_height(1);
  EXPECT_TRUE(contacts.empty());
  EXPECT_EQ(value, 0);
  link_at_height(-1);
  EXPECT_TRUE(contacts.empty());
  EXPECT_EQ(std::abs(value), 1);
}

// Where a copy crosses an edge of a walk, a face beside the edge is seen as a line: another
// direction tells. At another edge the loops cross the other way, as closed ones do.
TEST(Touched_edge, IsSeenFromElsewhereIfAFaceIsSeenAsALine) {
  const auto [a, b] = first_direction();
  Surface_curves curves;
  curves.vertices = {{0., 0., 0.}, {1., 0., 0.}, {0.5 + a, b, 1.}, {0.5, -1., -0.25},
                     {8., 0., 0.}, {9., 0., 0.}, {8.5, 1., -1.},   {8.5, -1., -1.}};
  curves.edges = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  curves.walks.add(1, 0, 1);
  curves.walks.add(0, 1, 1);
  curves.crossings.add(0, 0, 1);
  curves.crossings.add(1, 1, -1);
  curves.walks.finish(Execution(), 2);
  curves.crossings.finish(Execution(), 2);
  curves.outward = {1, 1};
  EXPECT_TRUE(linking_of(curves).contacts.empty());
}

TEST(Boxes, AreFoundWhereTheyMeet) {
  using Rectangle = Box<2>;
  Random random(3);
  for(int round = 0; round < 50; ++round) {
    const auto random_box = [&] {
      const double x = static_cast<double>(random.below(20)),
                   y = static_cast<double>(random.below(20));
      return Rectangle{
          {x, y},
          {x + static_cast<double>(random.below(4)), y + static_cast<double>(random.below(4))}};
    };
    std::vector<Rectangle> boxes(random.below(100));
    for(Rectangle& b : boxes)
      b = random_box();
    const Box_tree<2> tree(boxes);
    for(int i = 0; i < 20; ++i) {
      const Rectangle box = random_box();
      std::set<Index> found, expected;
      tree.for_each_meeting(box, [&](Index j, const Rectangle& b) {
        EXPECT_EQ(b.low, boxes[j].low);
        EXPECT_TRUE(found.insert(j).second) << "found twice";
      });
      for(Index j = 0; j < boxes.size(); ++j)
        if(boxes[j].meets(box))
          expected.insert(j);
      EXPECT_EQ(tree.is_any_meeting(box), !expected.empty());
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
    chains.finish(Execution(), elements);
    std::map<std::pair<Index, Index>, int> found;
    for(Index element = 0; element < elements; ++element)
      for(const Matrix_entry& t : chains.of(element)) {
        EXPECT_NE(t.value, 0);
        EXPECT_TRUE(found.emplace(std::pair(element, t.column), t.value).second);
      }
    for(auto it = expected.begin(); it != expected.end();)
      it = it->second == 0 ? expected.erase(it) : std::next(it);
    EXPECT_EQ(found, expected);
  }
}

TEST(Matrix, AddsUpWhatIsAtOnePlace) {
  Sparse_matrix matrix = {{1, 2, 3}, {0, 5, 1}, {1, 2, -1}, {4, 4, 7}, {4, 4, -7}, {1, 0, 2}};
  add_up(Execution(), matrix);
  ASSERT_EQ(matrix.size(), 3u);
  EXPECT_TRUE(matrix[0].row == 0 && matrix[0].column == 5 && matrix[0].value == 1);
  EXPECT_TRUE(matrix[1].row == 1 && matrix[1].column == 0 && matrix[1].value == 2);
  EXPECT_TRUE(matrix[2].row == 1 && matrix[2].column == 2 && matrix[2].value == 2);
}

TEST(Matrix, IsMultipliedRowByRow) {
  Random random(5);
  for(int round = 0; round < 50; ++round) {
    const auto random_matrix = [&] {
      Sparse_matrix matrix;
      for(std::size_t i = random.below(30); i > 0; --i)
        matrix.push_back({static_cast<Index>(random.below(5)), static_cast<Index>(random.below(5)),
                          random.below(2) ? 1 : -1});
      add_up(Execution(), matrix);
      return matrix;
    };
    const Sparse_matrix a = random_matrix(), b = random_matrix();
    const auto row = [&](Index i) {
      const auto begin = std::lower_bound(b.begin(), b.end(), Matrix_entry{i, 0, 0}),
                 end = std::lower_bound(begin, b.end(), Matrix_entry{i + 1, 0, 0});
      return Span<const Matrix_entry>(b.data() + (begin - b.begin()),
                                      static_cast<std::size_t>(end - begin));
    };
    const auto is_kept = [](Index i, Index j) { return i != 2 || j != 3; };
    Sparse_matrix expected;
    for(const Matrix_entry& e : a)
      for(const Matrix_entry& f : row(e.column))
        if(is_kept(e.row, f.column))
          expected.push_back({e.row, f.column, e.value * f.value});
    add_up(Execution(), expected);
    const Sparse_matrix found = product(a, row, is_kept);
    ASSERT_EQ(found.size(), expected.size());
    for(std::size_t i = 0; i < found.size(); ++i)
      EXPECT_TRUE(found[i].is_beside(expected[i]) && found[i].value == expected[i].value);
  }
}

} // namespace test_projected_points
