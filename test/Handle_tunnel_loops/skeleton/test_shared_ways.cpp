// Arcs of a skeleton that run side by side share a way, and cycles stay what they are.

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Shared_ways.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace test_shared_ways {

using namespace CGAL::Handle_tunnel_loops::internal;

constexpr Index length = 8; // of a ladder

/// a ladder of two rails with rungs, with a ring at its end that the last rung closes.
struct Ladder
{
  Ladder() {
    for(const double y : {0.2, -0.2})
      for(Index i = 0; i < length; ++i)
        add_ball({double(i), y, 0.}, 0.5);
    for(Index i = 0; i + 1 < length; ++i)
      for(Index rail : {Index(0), length})
        graph.edges.push_back({rail + i, rail + i + 1});
    for(Index i = 0; i < length; ++i)
      graph.edges.push_back({i, length + i});
    const double end = double(length);
    const Index ring = add_ball({end, 1., 0.}, 0.3);
    add_ball({end + 1., 0., 0.}, 0.3);
    add_ball({end, -1., 0.}, 0.3);
    for(const Ball_graph::Edge& e : {Ball_graph::Edge{length - 1, ring},
                                     {ring, ring + 1},
                                     {ring + 1, ring + 2},
                                     {2 * length - 1, ring + 2}})
      graph.edges.push_back(e);
    graph.link();
    names.assign(graph.edges.size(), 0);
    names[edge(ring, ring + 1)] = 1;
    // All but the rungs, of which the first: a cycle along both rails.
    for(const Ball_graph::Edge& e : graph.edges)
      is_taken.push_back(e[1] != e[0] + length || e[0] == 0 || e[0] >= length);
  }

  Index add_ball(const std::array<double, 3>& centre, double radius) {
    graph.balls.push_back({centre, radius});
    graph.component.push_back(0);
    graph.is_inlet.push_back(0);
    return static_cast<Index>(graph.balls.size() - 1);
  }

  Index edge(Index a, Index b) const {
    return static_cast<Index>(
        std::find(graph.edges.begin(), graph.edges.end(), Ball_graph::Edge{a, b}) -
        graph.edges.begin());
  }

  std::size_t number_of_taken() const {
    return static_cast<std::size_t>(std::count(is_taken.begin(), is_taken.end(), char(1)));
  }

  Ball_graph graph;
  std::vector<std::uint64_t> names;
  std::vector<char> is_taken;
};

TEST(Shared_ways, LeadACycleNowhereAndBack) {
  Ladder ladder;
  ASSERT_EQ(ladder.number_of_taken(), 2u * (length - 1) + 1 + 4);
  Shared_ways(ladder.graph, ladder.names).find(ladder.is_taken);
  EXPECT_EQ(ladder.number_of_taken(), 1u + 4);
  EXPECT_TRUE(ladder.is_taken[ladder.edge(length - 1, 2 * length - 1)]);
}

TEST(Shared_ways, AreOneAsFarAsArcsRunSideBySide) {
  Ladder ladder;
  const Index tip = ladder.add_ball({-3., 0., 0.}, 0.5);
  ladder.graph.edges.push_back({0, tip});
  ladder.graph.link();
  const Index limb = ladder.edge(0, tip);
  ladder.names.insert(ladder.names.begin() + limb, 0);
  ladder.is_taken.insert(ladder.is_taken.begin() + limb, 1);
  Shared_ways(ladder.graph, ladder.names).find(ladder.is_taken);
  EXPECT_TRUE(ladder.is_taken[limb]);
  EXPECT_EQ(ladder.number_of_taken(), 1u + (length - 1) + 1 + 4);
}

TEST(Shared_ways, AreOneIfAnArcComesBackBesideWhereItBegan) {
  Ladder ladder;
  for(const Index joint : {Index(0), length}) {
    const Index tip = ladder.add_ball({-3., joint == 0 ? 1. : -1., 0.}, 0.5);
    ladder.graph.edges.push_back({joint, tip});
    ladder.graph.link();
    const Index limb = ladder.edge(joint, tip);
    ladder.names.insert(ladder.names.begin() + limb, 0);
    ladder.is_taken.insert(ladder.is_taken.begin() + limb, 1);
  }
  Shared_ways(ladder.graph, ladder.names).find(ladder.is_taken);
  EXPECT_EQ(ladder.number_of_taken(), 2u + 1 + (length - 1) + 1 + 4);
}

TEST(Shared_ways, KeepClasses) {
  Ladder ladder;
  ladder.names[ladder.edge(2, length + 2)] = 1; // something between the rails
  Shared_ways(ladder.graph, ladder.names).find(ladder.is_taken);
  std::uint64_t sum = 0;
  for(std::size_t e = 0; e < ladder.names.size(); ++e)
    sum += ladder.is_taken[e] != 0 ? ladder.names[e] : 0;
  EXPECT_EQ(sum, 1u);
}

} // namespace test_shared_ways
