// Simplified Reeb graphs against a simplification leaf by leaf, in which nothing is kept from step
// to step.

#include "Flat_mesh_of_soup.h"
#include "Reeb_leaf_by_leaf.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_finishing.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace test_reeb_simplification {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Reeb_measure;
using generators::Random;
using reeb_leaf_by_leaf::Leaf_by_leaf;
using Values = std::vector<double>;

// The places along each arc, by the nodes at its ends, counted among those that are left.
using Arcs = std::multimap<std::tuple<Index, Index, std::vector<Index>>, Polyline>;

Arcs arcs_of(const Undrawn_reeb_graph& undrawn) {
  Arcs arcs;
  for(std::size_t i = 0; i < undrawn.graph.arcs.size(); ++i) {
    const Embedded_reeb_graph::Arc& arc = undrawn.graph.arcs[i];
    std::vector<Index> vertices = arc.vertices;
    std::sort(vertices.begin(), vertices.end());
    Polyline line = {undrawn.graph.nodes[arc.lower].position};
    for(const Reeb_mean& mean : undrawn.means[i])
      line.push_back(to_vector(mean.position));
    line.push_back(undrawn.graph.nodes[arc.upper].position);
    arcs.emplace(std::tuple(arc.lower, arc.upper, vertices), line);
  }
  return arcs;
}

Arcs arcs_of(const Flat_reeb_graph& graph, const Leaf_by_leaf& expected) {
  std::set<Index> kept;
  for(const auto& path : expected.paths())
    kept.insert({path.lower, path.upper});
  const auto number = [&kept](Index node) {
    return static_cast<Index>(std::distance(kept.begin(), kept.find(node)));
  };
  Arcs arcs;
  for(const auto& path : expected.paths()) {
    std::vector<Index> vertices;
    for(Index v = 0; v < graph.vertex_arc.size(); ++v)
      if(std::count(path.arcs.begin(), path.arcs.end(), graph.vertex_arc[v]) != 0)
        vertices.push_back(v);
    arcs.emplace(std::tuple(number(path.lower), number(path.upper), vertices), expected.line(path));
  }
  return arcs;
}

double distance(const Polyline& a, const Polyline& b) {
  if(a.size() != b.size())
    return std::numeric_limits<double>::infinity();
  double largest = 0.;
  for(std::size_t i = 0; i < a.size(); ++i)
    largest = (std::max)(largest, norm(a[i] - b[i]));
  return largest;
}

std::string name_of(Reeb_measure measure) {
  switch(measure) {
  case Reeb_measure::LIMBS:
    return "Limbs";
  case Reeb_measure::PERSISTENCE:
    return "Persistence";
  case Reeb_measure::LENGTH:
    return "Length";
  case Reeb_measure::AREA:
    return "Area";
  default:
    return "Vertices";
  }
}

class Simplification : public testing::TestWithParam<Reeb_measure>
{
protected:
  void expect_leaf_by_leaf(const Flat_mesh& mesh, const Values& values, double threshold) {
    const Execution execution;
    const Sweep_order order(execution, mesh, [&](Index v) { return ordering_key(values[v]); });
    const std::vector<Star> stars = sweep_stars(execution, mesh, order);
    Reeb_sweep sweep(mesh, order, stars, (std::numeric_limits<std::uint64_t>::max)(), 0.01);
    const Flat_reeb_graph graph = sweep.run();
    const Leaf_by_leaf expected(mesh, graph, values, GetParam(), threshold);
    taken_off += graph.arcs.size() - expected.paths().size();
    for(const auto& path : expected.paths()) {
      left += expected.is_leaf(path);
      passed_downwards +=
          std::any_of(path.pieces.begin(), path.pieces.end(),
                      [](const reeb_leaf_by_leaf::Piece& piece) { return piece.is_reversed; });
    }

    Flat_reeb_graph copy = graph; // its samples are taken away
    std::vector<Index> all(mesh.first_hub);
    std::iota(all.begin(), all.end(), Index(0));
    const Function_on_vertices function(
        mesh,
        boost::make_function_property_map<Index>([&values](Index v) { return double(values[v]); }),
        all);
    const Reeb_finishing finishing(execution, mesh, order, copy, function);
    const Arcs found_arcs = arcs_of(finishing.simplified_graph(GetParam(), threshold));
    const Arcs expected_arcs = arcs_of(graph, expected);
    ASSERT_EQ(found_arcs.size(), expected_arcs.size());
    for(auto a = found_arcs.begin(), b = expected_arcs.begin(); a != found_arcs.end(); ++a, ++b) {
      ASSERT_EQ(a->first, b->first);
      const auto& [lower, upper, vertices] = a->first;
      Polyline reversed = b->second;
      if(lower == upper)
        std::reverse(reversed.begin(), reversed.end());
      EXPECT_EQ((std::min)(distance(a->second, b->second), distance(a->second, reversed)), 0.);
    }
  }

  std::size_t taken_off = 0, left = 0, passed_downwards = 0;
};

INSTANTIATE_TEST_SUITE_P(Measures,
                         Simplification,
                         testing::Values(Reeb_measure::LIMBS,
                                         Reeb_measure::PERSISTENCE,
                                         Reeb_measure::LENGTH,
                                         Reeb_measure::AREA,
                                         Reeb_measure::VERTICES),
                         [](const auto& test) { return name_of(test.param); });

TEST_P(Simplification, OfRandomFunctionsIsLeafByLeaf) {
  Random random(1);
  for(int i = 0; i < 200; ++i) {
    const std::size_t genus = random.below(5);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(150), genus, static_cast<unsigned>(random.next())}};
    const double threshold = std::pow(10., random.uniform(-3., 0.));
    SCOPED_TRACE(testing::Message() << recipe << ", threshold " << threshold);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Values values;
    for(std::size_t v = 0; v < mesh.number_of_vertices(); ++v)
      values.push_back(random.uniform(-1., 1.));
    expect_leaf_by_leaf(mesh, values, threshold);
  }
  EXPECT_GT(taken_off, 1000u);
  EXPECT_GT(left, 100u);
  EXPECT_GT(passed_downwards, 50u);
}

// With fewer and longer arcs, which have many means.
TEST_P(Simplification, OfRoughHeightsIsLeafByLeaf) {
  Random random(2);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1))
    for(const double noise : {0.02, 0.2}) {
      const double threshold = std::pow(10., random.uniform(-3., -0.5));
      SCOPED_TRACE(testing::Message()
                   << recipe << ", noise " << noise << ", threshold " << threshold);
      const Flat_mesh mesh = flat_mesh_of(recipe);
      Values values;
      for(const Vector& p : mesh.points)
        values.push_back(p[0] + 0.3 * p[1] + 0.1 * p[2] + noise * random.uniform(0., 1.));
      expect_leaf_by_leaf(mesh, values, threshold);
    }
  EXPECT_GT(taken_off, std::size_t((std::min)(100, number_of_cases(500))));
  EXPECT_GT(left, 10u);
}

} // namespace test_reeb_simplification
