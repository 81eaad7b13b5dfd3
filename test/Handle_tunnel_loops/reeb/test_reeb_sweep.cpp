// The sweep that finds the Reeb graph of an order of the vertices, whatever the order.

#include "Flat_mesh_of_soup.h"
#include "Ladder.h"
#include "Reeb_by_levels.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace test_reeb_sweep {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;

constexpr std::uint64_t unlimited = (std::numeric_limits<std::uint64_t>::max)();
const auto execution = Execution();

using Values = std::vector<int>;

Sweep_order order_of(const Flat_mesh& mesh, const Values& values) {
  return Sweep_order(execution, mesh, [&](Index v) { return ordering_key(values[v]); });
}

Flat_reeb_graph swept(const Flat_mesh& mesh,
                      const Sweep_order& order,
                      std::uint64_t largest_number_of_steps = unlimited) {
  const std::vector<Star> stars = sweep_stars(execution, mesh, order);
  Reeb_sweep sweep(mesh, order, stars, largest_number_of_steps, 0.01);
  return sweep.run();
}

// Few different values have large plateaus.
Values random_values(const Flat_mesh& mesh, Random& random, std::size_t number_of_values) {
  Values values(mesh.number_of_vertices());
  for(int& value : values)
    value = static_cast<int>(random.below(number_of_values)) - 5;
  return values;
}

Values heights(const Flat_mesh& mesh, double noise, Random& random) {
  Values values;
  for(const Vector& p : mesh.points)
    values.push_back(static_cast<int>(1e6 * (p[0] + 0.3 * p[1] + noise * random.uniform(0., 1.))));
  return values;
}

void expect_graph_of_closed_surface(const Flat_mesh& mesh, const Flat_reeb_graph& graph) {
  std::vector<int> below(graph.nodes.size(), 0), above(graph.nodes.size(), 0);
  for(const auto& arc : graph.arcs) {
    ASSERT_LT(arc.lower, graph.nodes.size());
    ASSERT_LT(arc.upper, graph.nodes.size());
    ASSERT_LT(arc.lower, arc.upper);
    ++above[arc.lower];
    ++below[arc.upper];
  }
  std::ptrdiff_t sum = 0;
  for(std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const bool is_saddle = graph.nodes[i].kind == Node_kind::SADDLE;
    sum += is_saddle ? -1 : 1;
    EXPECT_EQ(below[i] + above[i], is_saddle ? 3 : 1);
    EXPECT_EQ(below[i] == 0, graph.nodes[i].kind == Node_kind::MINIMUM);
    EXPECT_EQ(above[i] == 0, graph.nodes[i].kind == Node_kind::MAXIMUM);
  }
  EXPECT_EQ(sum, 2 - 2 * static_cast<std::ptrdiff_t>(mesh.genus));
  EXPECT_EQ(graph.arcs.size() + 1, graph.nodes.size() + mesh.genus);
}

void expect_same(const Flat_reeb_graph& a, const Flat_reeb_graph& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for(std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_EQ(a.nodes[i].vertex, b.nodes[i].vertex);
    EXPECT_EQ(a.nodes[i].kind, b.nodes[i].kind);
    EXPECT_LT(norm(a.nodes[i].position - b.nodes[i].position), 1e-4);
  }
  EXPECT_EQ(reeb_by_levels::reeb_arcs(a), reeb_by_levels::reeb_arcs(b));
}

// The contours that touch a vertex, just below or just above it, each added up edge by edge.
std::vector<Front_mean>
fronts_at(const Flat_mesh& mesh, const Sweep_order& order, Index v, bool is_above) {
  const auto contours =
      reeb_by_levels::contours_below(mesh, order, order.rank(v) + (is_above ? 1 : 0));
  std::map<int, Front_mean> fronts;
  for(const Index u : mesh.ring(v))
    if((order.rank(u) > order.rank(v)) == is_above)
      fronts[contours.at(is_above ? std::pair(v, u) : std::pair(u, v))];
  for(const auto& [edge, contour] : contours)
    if(fronts.count(contour) != 0) {
      const auto ring = mesh.ring(edge.first);
      fronts[contour] +=
          crossing_of_front(mesh, order, edge.first, ring, ring.position(edge.second));
    }
  std::vector<Front_mean> all;
  for(const auto& [contour, front] : fronts)
    all.push_back(front);
  return all;
}

void expect_same_girths(std::vector<float> found, const std::vector<Front_mean>& fronts) {
  std::vector<float> expected;
  for(const Front_mean& front : fronts)
    expected.push_back(front.girth());
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-4 * (1. + expected[i]));
}

// The lengths of the fronts at the ends of arcs, and their means at saddles. Where a saddle is
// unfolded, what is between its nodes is left out.
void expect_fronts(const Flat_mesh& mesh, const Sweep_order& order, const Flat_reeb_graph& graph) {
  std::map<Index, std::vector<float>> lower_girths, upper_girths; // by vertex
  for(const auto& arc : graph.arcs) {
    const Index lower = graph.nodes[arc.lower].vertex, upper = graph.nodes[arc.upper].vertex;
    if(lower != upper) {
      upper_girths[upper].push_back(arc.upper_girth);
      if(graph.nodes[arc.lower].kind == Node_kind::SADDLE)
        lower_girths[lower].push_back(arc.lower_girth);
    }
  }
  for(const auto& [v, girths] : upper_girths)
    expect_same_girths(girths, fronts_at(mesh, order, v, false));
  for(const auto& [v, girths] : lower_girths)
    expect_same_girths(girths, fronts_at(mesh, order, v, true));
  for(const auto& node : graph.nodes)
    if(node.kind == Node_kind::SADDLE) {
      Front_mean all;
      for(const Front_mean& front : fronts_at(mesh, order, node.vertex, false))
        all += front;
      EXPECT_LT(norm(node.position - all.mean(mesh.points[node.vertex])), 1e-4);
    }
}

void expect_reeb_graph(const Flat_mesh& mesh, const Values& values) {
  const Sweep_order order = order_of(mesh, values);
  const Flat_reeb_graph graph = swept(mesh, order);
  expect_graph_of_closed_surface(mesh, graph);
  expect_fronts(mesh, order, graph);
  EXPECT_EQ(reeb_by_levels::reeb_arcs(graph), reeb_by_levels::reeb_arcs(mesh, order));
  for(const std::uint64_t limit : {0, 20}) {
    SCOPED_TRACE(testing::Message() << "trees after " << limit << " steps");
    expect_same(graph, swept(mesh, order, limit));
  }
}

TEST(Reeb_sweep, AgreesWithTheLevelsOneByOne) {
  Random random(1);
  for(int i = 0; i < 300; ++i) {
    const std::size_t genus = random.below(6);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(100), genus, static_cast<unsigned>(random.next())}};
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::size_t number_of_values = i % 3 == 0 ? 3 : 1000000;
    SCOPED_TRACE(testing::Message() << recipe << ", values " << number_of_values);
    expect_reeb_graph(mesh, random_values(mesh, random, number_of_values));
  }
}

TEST(Reeb_sweep, AgreesWithTheLevelsOnEveryOrderOfTheSmallestTorus) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  Values values(7);
  std::iota(values.begin(), values.end(), 0);
  do {
    SCOPED_TRACE(testing::PrintToString(values));
    expect_reeb_graph(mesh, values);
  } while(std::next_permutation(values.begin(), values.end()));
}

TEST(Reeb_sweep, AgreesWithTheLevelsOnSmoothSurfaces) {
  Random random(2);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2}, 1)) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    for(const double noise : {0., 0.1}) {
      SCOPED_TRACE(testing::Message() << recipe << ", noise " << noise);
      expect_reeb_graph(mesh, heights(mesh, noise, random));
    }
  }
}

TEST(Reeb_sweep, HasAsManyCyclesAsHandles) {
  Random random(3);
  for(int i = 0; i < 3000; ++i) {
    const std::size_t genus = random.below(30);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(400), genus, static_cast<unsigned>(random.next())}};
    const Flat_mesh mesh = flat_mesh_of(recipe);
    SCOPED_TRACE(testing::Message() << recipe);
    const Sweep_order order = order_of(mesh, random_values(mesh, random, i % 2 == 0 ? 4 : 1 << 30));
    expect_graph_of_closed_surface(mesh, swept(mesh, order, i % 4 < 2 ? unlimited : i));
  }
}

Values heights_of(const Flat_mesh& ladder) {
  Values values;
  for(const Vector& p : ladder.points)
    values.push_back(static_cast<int>(10000. * p[2]));
  return values;
}

TEST(Reeb_sweep, AgreesWithTheLevelsOnLadders) {
  for(const std::uint32_t rungs : {1, 2, 5}) {
    const Flat_mesh mesh = flat_mesh_of(Ladder(8, rungs).soup());
    ASSERT_EQ(mesh.genus, rungs - 1);
    expect_reeb_graph(mesh, heights_of(mesh));
  }
}

// Without trees the number of steps is quadratic.
TEST(Reeb_sweep, DoesNotWalkForEver) {
  const Flat_mesh mesh = flat_mesh_of(Ladder(2000, 2000).soup());
  const Sweep_order order = order_of(mesh, heights_of(mesh));
  const std::vector<Star> stars = sweep_stars(execution, mesh, order);
  Reeb_sweep endless(mesh, order, stars, unlimited, 0.01);
  const Flat_reeb_graph expected = endless.run();
  expect_graph_of_closed_surface(mesh, expected);
  EXPECT_GT(endless.number_of_steps(), std::uint64_t(2000) * 2000);
  const std::uint64_t limit = 8 * mesh.neighbor.size();
  Reeb_sweep limited(mesh, order, stars, limit, 0.01);
  expect_same(expected, limited.run());
  EXPECT_TRUE(limited.has_used_trees());
  EXPECT_LT(limited.number_of_steps(), limit + mesh.neighbor.size());
}

TEST(Ordering_key, OrdersAsTheNumbers) {
  EXPECT_EQ(ordering_key(-0.), ordering_key(0.));
  EXPECT_LT(ordering_key(-2.5), ordering_key(-1.));
  EXPECT_LT(ordering_key(-1e-300), ordering_key(1e-300));
  EXPECT_LT(ordering_key(1.), ordering_key(1.5));
  EXPECT_LT(ordering_key(-1), ordering_key(0));
  EXPECT_LT(ordering_key(std::int64_t(1) << 60), ordering_key((std::int64_t(1) << 60) + 1));
  EXPECT_LT(ordering_key(std::uint64_t(1)),
            ordering_key((std::numeric_limits<std::uint64_t>::max)()));
}

} // namespace test_reeb_sweep
