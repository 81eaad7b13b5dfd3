// Which of two loops is longer: to the last digit, whatever the digits of double say.

#include "Changed_loops.h"
#include "Crossing_loops.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace test_compare_lengths {

using CGAL::Comparison_result;
using CGAL::Handle_tunnel_loops::internal::Edge_place;
using CGAL::Handle_tunnel_loops::internal::length_interval;
using CGAL::Handle_tunnel_loops::internal::Vector;

Crossing_loop rotated(Crossing_loop loop, std::size_t start) {
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(start), loop.end());
  return loop;
}

Crossing_loop with_random_ratios(Crossing_loop loop, Random& random) {
  for(Crossing& c : loop)
    c.ratio = random.below(4) == 0 ? double(random.below(2)) : random.uniform(0., 1.);
  return loop;
}

long double long_length(const std::vector<Edge_place>& places) {
  using Point = std::array<long double, 3>;
  const auto point = [](const Edge_place& place) {
    Point result;
    for(int d = 0; d < 3; ++d) {
      const long double p = place.p[d], q = place.q[d];
      result[d] = p + place.ratio * (q - p);
    }
    return result;
  };
  long double sum = 0.;
  for(std::size_t i = 0; i < places.size(); ++i) {
    const Point p = point(places[i]), q = point(places[(i + 1) % places.size()]);
    sum += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }
  return sum;
}

long double long_length(const Flat_mesh& mesh, const Crossing_loop& loop) {
  return long_length(edge_places(mesh, loop));
}

TEST(Compare_lengths, OfALoopWithItselfIsEqual) {
  Random random(1);
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    for(Crossing_loop& loop : random_loops(mesh, random, 5)) {
      if(loop.empty())
        continue;
      loop = with_random_ratios(std::move(loop), random);
      Crossing_loop other = rotated(loop, random.below(loop.size()));
      EXPECT_EQ(compare_lengths(mesh, loop, other), CGAL::EQUAL);
      std::reverse(other.begin(), other.end());
      EXPECT_EQ(compare_lengths(mesh, loop, other), CGAL::EQUAL);
      EXPECT_EQ(compare_lengths(mesh, loop, {}), CGAL::LARGER);
      EXPECT_EQ(compare_lengths(mesh, {}, loop), CGAL::SMALLER);
    }
  }
}

TEST(Compare_lengths, AgreesWithLongDoubleFarFromEqual) {
  Random random(2);
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    std::vector<Crossing_loop> loops = random_loops(mesh, random, 10);
    for(Crossing_loop& loop : loops)
      loop = with_random_ratios(std::move(loop), random);
    for(const Crossing_loop& a : loops)
      for(const Crossing_loop& b : loops) {
        const long double difference = long_length(mesh, a) - long_length(mesh, b);
        const Comparison_result result = compare_lengths(mesh, a, b);
        EXPECT_EQ(result, CGAL::opposite(compare_lengths(mesh, b, a)));
        if(std::abs(difference) > 1e-12L) {
          EXPECT_EQ(result, difference > 0 ? CGAL::LARGER : CGAL::SMALLER);
        }
      }
  }
}

// Moved by the last digit of one ratio, a loop is no longer as long as it was, but hardly ever
// differs from that in its length as a double.
TEST(Compare_lengths, SeesTheLastDigit) {
  Random random(3);
  const Flat_mesh mesh = flat_mesh_of({"knot", {1200, 1, 0}});
  int same_as_doubles = 0, all = 0;
  for(Crossing_loop& loop : random_loops(mesh, random, 30)) {
    if(loop.empty())
      continue;
    for(Crossing& c : loop) // at no vertex: between two of them an edge may be the loop
      c.ratio = random.uniform(0.1, 0.4);
    Crossing_loop moved = loop;
    double& ratio = moved[random.below(moved.size())].ratio;
    ratio = std::nextafter(ratio, 0.5);
    const Comparison_result result = compare_lengths(mesh, loop, moved);
    EXPECT_NE(result, CGAL::EQUAL);
    EXPECT_EQ(result, CGAL::opposite(compare_lengths(mesh, moved, loop)));
    same_as_doubles += length(mesh, loop) == length(mesh, moved);
    ++all;
  }
  EXPECT_GT(same_as_doubles, all / 4);
}

std::vector<Edge_place> there_and_back(const std::vector<Vector>& points) {
  std::vector<Edge_place> places;
  for(const Vector& p : points)
    places.push_back({p, p, 0.});
  return places;
}

// The square root of n^2 + 1 is n + 1 / (2 n), less nearly nothing.
TEST(Compare_lengths, IsRightWhereDoubleIsWrong) {
  for(int exponent = 27; exponent < 300; exponent += 7) {
    SCOPED_TRACE(exponent);
    const double n = std::ldexp(1., exponent);
    ASSERT_EQ(std::sqrt(n * n + 1.), n);
    const auto straight = there_and_back({{0., 0., 0.}, {n, 0., 0.}}),
               oblique = there_and_back({{0., 0., 0.}, {n, 1., 0.}}),
               halves = there_and_back({{0., 0., 0.}, {n / 2., 0., 0.}, {n, 0., 0.}});
    EXPECT_EQ(compare_lengths(oblique, straight), CGAL::LARGER);
    EXPECT_EQ(compare_lengths(straight, oblique), CGAL::SMALLER);
    EXPECT_EQ(compare_lengths(halves, straight), CGAL::EQUAL);
    EXPECT_EQ(compare_lengths(halves, oblique), CGAL::SMALLER);
  }
}

// The intervals are without bounds.
TEST(Compare_lengths, DoesNotOverflow) {
  const auto a = there_and_back({{0., 0., 0.}, {1e300, 1., 0.}}),
             b = there_and_back({{0., 0., 0.}, {1e300, 0., 0.}}),
             c = there_and_back({{0., 0., 0.}, {1e-320, 0., 0.}}),
             d = there_and_back({{0., 0., 0.}, {2e-320, 0., 0.}});
  EXPECT_EQ(compare_lengths(a, b), CGAL::LARGER);
  EXPECT_EQ(compare_lengths(c, d), CGAL::SMALLER);
  EXPECT_EQ(compare_lengths(c, {}), CGAL::LARGER);
}

// A torus that does not change, to the last digit, when it is turned by a right angle.
class Symmetric_torus : public testing::Test
{
protected:
  static constexpr Index columns = 8, rows = 5;

  static Index vertex(Index i, Index j) { return (i % columns) * rows + j % rows; }

  Symmetric_torus() {
    for(Index i = 0; i < columns; ++i)
      for(Index j = 0; j < rows; ++j) {
        const double angle = 2. * CGAL_PI * j / rows, radius = 3. + std::cos(angle);
        std::array<double, 3> p = {radius * (i % 2 == 0 ? 1. : 0.7), i % 2 == 0 ? 0. : 0.6 * radius,
                                   std::sin(angle)};
        for(Index turns = i / 2; turns > 0; --turns)
          p = {-p[1], p[0], p[2]};
        soup.points.push_back(p);
        const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                    d = vertex(i, j + 1);
        soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
      }
  }

  // Around the tube, between a column and the next.
  static Crossing_loop around(Index i, const std::vector<double>& ratios) {
    Crossing_loop loop;
    for(Index j = 0; j < rows; ++j) {
      loop.push_back({vertex(i, j), vertex(i + 1, j), ratios[2 * j]});
      loop.push_back({vertex(i, j), vertex(i + 1, j + 1), ratios[2 * j + 1]});
    }
    return loop;
  }

  Soup soup;
};

template <typename TriangleMesh> auto on_mesh(const Crossing_loop& loop, const TriangleMesh& tm) {
  using Loop = CGAL::Loop_on_surface<TriangleMesh>;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  std::vector<typename Loop::Step> steps;
  for(const Crossing& c : loop)
    steps.push_back({halfedge(Vertex(c.left), Vertex(c.right), tm).first, c.ratio});
  return Loop(steps, {}, 0., CGAL::Loop_type::HANDLE, 0);
}

TEST_F(Symmetric_torus, HasLoopsOfEqualLengths) {
  const Mesh mesh = mesh_of(soup);
  using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>;
  const Exact_mesh exact_mesh = mesh_of<Exact_mesh>(soup);
  const auto expect = [&](const Crossing_loop& a, const Crossing_loop& b,
                          Comparison_result result) {
    EXPECT_EQ(compare_lengths(flat_mesh_of(soup), a, b), result);
    EXPECT_EQ(CGAL::compare_lengths(on_mesh(a, mesh), on_mesh(b, mesh), mesh), result);
    EXPECT_EQ(CGAL::compare_lengths(on_mesh(a, mesh), on_mesh(b, mesh), mesh,
                                    CGAL::parameters::vertex_point_map(mesh.points())),
              result);
    EXPECT_EQ(CGAL::compare_lengths(on_mesh(a, exact_mesh), on_mesh(b, exact_mesh), exact_mesh),
              result);
  };
  Random random(4);
  for(int round = 0; round < 10; ++round) {
    std::vector<double> ratios;
    while(ratios.size() < 2 * rows)
      ratios.push_back(random.uniform(0.1, 0.9));
    const Crossing_loop loop = around(0, ratios);
    expect_crossing_loop(flat_mesh_of(soup), loop);
    for(Index i = 2; i < columns; i += 2)
      expect(loop, around(i, ratios), CGAL::EQUAL);
    // Farther from the straight way than the whole loop can be off.
    ratios[3] = 100. * ratios[3];
    expect(loop, around(2, ratios), CGAL::SMALLER);
  }
}

// ---- intervals

TEST(Length_interval, HoldsTheLength) {
  Random random(5);
  for(std::size_t size = 3; size < 200; ++size) {
    std::vector<Edge_place> places(size);
    const double scale = std::pow(10., random.uniform(-100., 100.));
    for(Edge_place& place : places) {
      for(int d = 0; d < 3; ++d) {
        place.p[d] = scale * random.uniform(-1., 1.);
        place.q[d] = scale * random.uniform(-1., 1.);
      }
      place.ratio = random.uniform(0., 1.);
    }
    const auto [least, most] = length_interval(places);
    const long double length = long_length(places);
    EXPECT_LE(least, length);
    EXPECT_GE(most, length);
    EXPECT_LE(most - least, 1e-15 * double(size + 4) * most);
  }
}

TEST(Length_interval, IsNarrowWhereNothingIsRounded) {
  const auto at = [](double x, double y) { return Edge_place{{x, y, 0.}, {x, y, 0.}, 0.5}; };
  EXPECT_EQ(length_interval({at(0., 0.), at(3., 0.), at(3., 4.)}), std::make_pair(12., 12.));
  EXPECT_EQ(length_interval(std::vector<Edge_place>()), std::make_pair(0., 0.));
}

// As they come out, on a mesh of any kernel.
TEST(Length_interval, HoldsWhatLoopsSay) {
  const Mesh mesh = mesh_of(Recipe{"foam", {6000, 4, 1}});
  for(const auto& pair : find_loops(mesh))
    for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
      const auto [least, most] = CGAL::length_interval(*loop, mesh);
      EXPECT_LT(most - least, 1e-11 * most);
      EXPECT_NEAR(loop->length(), least, 1e-9 * most);
    }
}

} // namespace test_compare_lengths
