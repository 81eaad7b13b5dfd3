// Shortest paths are those of relaxing all edges again and again, and each place is visited once.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace test_shortest_paths {

using CGAL::Handle_tunnel_loops::internal::Index;
using CGAL::Handle_tunnel_loops::internal::Shortest_paths;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Label
{
  double distance = infinity;
};

struct Arc
{
  Index from, to;
  double length;
};

class Shortest_paths_test : public testing::Test
{
protected:
  // Many lengths are equal, and some are zero.
  void SetUp() override {
    for(std::size_t i = 0; i < 4 * size; ++i)
      arcs.push_back({random_place(), random_place(), double(random.below(6))});
  }

  Index random_place() { return static_cast<Index>(random.below(size)); }

  std::vector<double> by_relaxation(Index source) const {
    std::vector<double> distance(size, infinity);
    distance[source] = 0.;
    for(std::size_t round = 0; round < size; ++round)
      for(const Arc& a : arcs)
        distance[a.to] = (std::min)(distance[a.to], distance[a.from] + a.length);
    return distance;
  }

  // Places in the order in which they are visited.
  std::vector<Index> grow(double limit = infinity) {
    std::vector<Index> visited;
    paths.grow([&](double distance) { return distance < limit; },
               [&](Index i) {
                 visited.push_back(i);
                 for(const Arc& a : arcs)
                   if(a.from == i && paths[i].distance + a.length < paths[a.to].distance)
                     paths.reach(a.to, {paths[i].distance + a.length});
               });
    return visited;
  }

  static constexpr std::size_t size = 60;
  CGAL::Handle_tunnel_loops::generators::Random random{5};
  std::vector<Arc> arcs;
  Shortest_paths<Label> paths{size};
};

TEST_F(Shortest_paths_test, AreAsShortAsAny) {
  for(int round = 0; round < 20; ++round) {
    const Index source = random_place();
    const std::vector<double> expected = by_relaxation(source);
    paths.reach(source, {0.});
    const std::vector<Index> visited = grow();
    std::vector<int> visits(size, 0);
    for(std::size_t i = 0; i < visited.size(); ++i) {
      ++visits[visited[i]];
      EXPECT_LE(paths[visited[i == 0 ? 0 : i - 1]].distance, paths[visited[i]].distance);
    }
    for(Index i = 0; i < size; ++i) {
      EXPECT_EQ(paths[i].distance, expected[i]);
      EXPECT_EQ(visits[i], paths.is_reached(i) ? 1 : 0) << "place " << i;
    }
    EXPECT_EQ(paths.reached().size(), visited.size());
    paths.clear();
    EXPECT_TRUE(paths.reached().empty());
    EXPECT_FALSE(paths.is_reached(source));
  }
}

TEST_F(Shortest_paths_test, GoOnWhereTheyHaveStopped) {
  paths.reach(0, {0.});
  const std::vector<Index> all = grow();
  paths.clear();
  paths.reach(0, {0.});
  std::vector<Index> visited = grow(3.);
  EXPECT_FALSE(visited.empty());
  EXPECT_LT(visited.size(), all.size());
  const std::vector<Index> rest = grow();
  visited.insert(visited.end(), rest.begin(), rest.end());
  EXPECT_EQ(visited, all);
}

// The nearest first, of equally near places the first one; whatever the type of the distances.
template <typename Distance> void expect_order() {
  CGAL::Handle_tunnel_loops::generators::Random random(7);
  CGAL::Handle_tunnel_loops::internal::Distance_queue<Distance> queue;
  struct Labelled
  {
    Distance distance;
  };
  std::vector<Labelled> labels;
  for(Index i = 0; i < 500; ++i) {
    labels.push_back({Distance(random.below(20)) / 8});
    queue.push(labels.back().distance, i);
  }
  std::vector<std::pair<Distance, Index>> visited, expected;
  for(Index i = 0; i < 500; ++i)
    expected.emplace_back(labels[i].distance, i);
  std::sort(expected.begin(), expected.end());
  queue.run(
      labels, [](Distance) { return true; },
      [&](Index i) { visited.emplace_back(labels[i].distance, i); });
  EXPECT_EQ(visited, expected);
}

TEST(Distance_queue, IsInTheOrderOfDistancesAndPlaces) {
  expect_order<float>();
  expect_order<double>();
}

} // namespace test_shortest_paths
