// Subsets of vertices, against sets of the standard library.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Vertex_subset.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

namespace test_vertex_subset {

using CGAL::Handle_tunnel_loops::generators::Random;
using namespace CGAL::Handle_tunnel_loops::internal;

void expect_the_same(std::size_t number_of_vertices, const std::set<Index>& expected) {
  Vertex_subset subset(number_of_vertices);
  for(Index v : expected)
    for(int i = 0; i < 2; ++i)
      subset.insert(v);
  subset.count();
  EXPECT_EQ(subset.size(), expected.size());
  EXPECT_EQ(subset.vertices(), std::vector<Index>(expected.begin(), expected.end()));
  std::size_t before = 0;
  for(Index v = 0; v < number_of_vertices; ++v) {
    EXPECT_EQ(subset.contains(v), expected.count(v) != 0);
    EXPECT_EQ(subset.number_before(v), before);
    before += expected.count(v);
  }
  EXPECT_EQ(subset.number_before(static_cast<Index>(number_of_vertices)), expected.size());
}

TEST(Vertex_subset, HasWhatWasInserted) {
  Random random(1);
  for(std::size_t n : {0, 1, 63, 64, 65, 127, 128, 1000})
    for(int round = 0; round < 20; ++round) {
      std::set<Index> expected;
      for(std::size_t i = n == 0 ? 0 : random.below(n + 1); i-- > 0;)
        expected.insert(static_cast<Index>(random.below(n)));
      expect_the_same(n, expected);
    }
}

TEST(Vertex_subset, MayHaveAll) {
  for(Index n : {1u, 64u, 65u, 128u, 300u}) {
    std::set<Index> all;
    for(Index v = 0; v < n; ++v)
      all.insert(all.end(), v);
    expect_the_same(n, all);
  }
}

} // namespace test_vertex_subset
