// Loops across edges, walks along edges, and their intersection numbers.

#include "Torus_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace test_crossing_loops {

using CGAL::Handle_tunnel_loops::internal::for_each_left_edge;
using CGAL::Handle_tunnel_loops::internal::Loop_walls;
using CGAL::Handle_tunnel_loops::internal::Loops_from;
using CGAL::Handle_tunnel_loops::internal::pushed_left;
using CGAL::Handle_tunnel_loops::internal::remove_backtracks;
using CGAL::Handle_tunnel_loops::internal::remove_spurs;
using CGAL::Handle_tunnel_loops::internal::very_many_neighbors;

class Crossing_loops : public testing::TestWithParam<Recipe>
{
protected:
  const Flat_mesh mesh = flat_mesh_of(GetParam());
  Random random{1};
};

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Crossing_loops,
                         testing::Values(Recipe{"sphere", {200, 0, 0}},
                                         Recipe{"torus", {200, 1, 0}},
                                         Recipe{"multi-torus", {1200, 3, 0}},
                                         Recipe{"hubs", {6000, 3, 0}},
                                         Recipe{"random", {14, 1, 0}},
                                         Recipe{"random", {100, 7, 1}},
                                         Recipe{"random", {800, 5, 2}}),
                         [](const auto& test) { return "Mesh" + std::to_string(test.index); });

TEST_P(Crossing_loops, PushedOffAWalkAreLoops) {
  for(const Crossing_loop& loop : random_loops(mesh, random, 50))
    expect_crossing_loop(mesh, loop);
}

// To its left, what the loop crosses ends, on the right, at the walk; and where there are very many
// neighbours, on the side with fewer of them.
TEST_P(Crossing_loops, PushedOffAWalkRunBesideIt) {
  const auto has_very_many = [&](Index v) { return mesh.ring(v).size() > very_many_neighbors; };
  for(int i = 0; i < 50; ++i) {
    const Vertex_walk walk = random_walk_without_spurs(mesh, random);
    const std::set<Index> vertices(walk.begin(), walk.end());
    std::size_t most_crossings = walk.size();
    for(const Index v : walk)
      most_crossings += mesh.ring(v).size() / (has_very_many(v) ? 2 : 1);
    const Crossing_loop loop = pushed_left(mesh, walk);
    EXPECT_LE(loop.size(), most_crossings);
    for(const Crossing& c : loop)
      EXPECT_TRUE(vertices.count(c.right) == 1 ||
                  (has_very_many(c.left) && vertices.count(c.left) == 1));
  }
}

TEST_P(Crossing_loops, HaveAntisymmetricIntersectionNumbers) {
  const std::vector<Crossing_loop> loops = random_loops(mesh, random, 40);
  const Integer_matrix matrix =
      intersection_matrix(loops, Crossing_index(mesh, loops), loops.size());
  bool has_intersections = false;
  for(std::size_t i = 0; i < loops.size(); ++i)
    for(std::size_t j = 0; j <= i; ++j) {
      EXPECT_EQ(matrix[i][j], -matrix[j][i]);
      has_intersections = has_intersections || matrix[i][j] != 0;
    }
  EXPECT_EQ(has_intersections, mesh.genus != 0);
}

TEST_P(Crossing_loops, ChangeSignWithTheirDirection) {
  const std::vector<Crossing_loop> loops = random_loops(mesh, random, 20);
  const Crossing_index index(mesh, loops);
  for(const Crossing_loop& loop : random_loops(mesh, random, 20)) {
    expect_crossing_loop(mesh, reversed(loop));
    Sparse_numbers negated = index.intersections(reversed(loop));
    for(auto& entry : negated)
      entry.second = -entry.second;
    EXPECT_EQ(index.intersections(loop), negated);
  }
}

// A walk, the loop beside it, and both after they were simplified, are homotopic.
TEST_P(Crossing_loops, HaveTheNumbersOfTheirWalks) {
  const std::vector<Crossing_loop> loops = random_loops(mesh, random, 20);
  const Crossing_index index(mesh, loops);
  for(int i = 0; i < 50; ++i) {
    Vertex_walk walk = random_walk(mesh, random);
    const Sparse_numbers numbers = index.intersections(walk);
    remove_spurs(walk);
    EXPECT_EQ(index.intersections(walk), numbers);
    if(walk.size() < 3)
      continue;
    Crossing_loop loop = pushed_left(mesh, walk);
    EXPECT_EQ(index.intersections(loop), numbers);
    std::rotate(loop.begin(), loop.begin() + loop.size() / 2, loop.end());
    EXPECT_EQ(index.intersections(loop), numbers);
  }
}

TEST_P(Crossing_loops, AreNotChangedByBacktracks) {
  const std::vector<Crossing_loop> loops = random_loops(mesh, random, 20);
  const Crossing_index index(mesh, loops);
  for(Crossing_loop loop : random_loops(mesh, random, 50)) {
    if(loop.empty())
      continue;
    const Crossing_loop expected = loop;
    // Into the triangle ahead, out through its left edge, and back: all over the loop.
    for(int i = 0; i < 5; ++i) {
      const std::size_t at = random.below(loop.size());
      const Crossing c = loop[at];
      const Index apex = mesh.ring(c.left).after(c.right);
      const Crossing out = {c.left, apex, 0.5}, back = {apex, c.left, 0.5};
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(at) + 1, {out, back});
    }
    EXPECT_EQ(index.intersections(loop), index.intersections(expected));
    remove_backtracks(loop);
    expect_crossing_loop(mesh, loop);
    EXPECT_EQ(loop.size(), expected.size());
    EXPECT_EQ(index.intersections(loop), index.intersections(expected));
  }
}

TEST_P(Crossing_loops, HaveNoBacktracksLeft) {
  for(const Crossing_loop& loop : random_loops(mesh, random, 50))
    for(std::size_t i = 0; loop.size() > 1 && i < loop.size(); ++i) {
      const Crossing &a = loop[i], &b = loop[(i + 1) % loop.size()];
      EXPECT_FALSE(a.left == b.right && a.right == b.left);
    }
}

TEST_P(Crossing_loops, HaveNoSpursLeft) {
  for(int i = 0; i < 50; ++i) {
    Vertex_walk walk = random_walk(mesh, random);
    remove_spurs(walk);
    const std::size_t n = walk.size();
    for(std::size_t j = 0; n >= 3 && j < n; ++j) {
      EXPECT_NE(walk[j], walk[(j + 1) % n]);
      EXPECT_NE(walk[j], walk[(j + 2) % n]);
    }
  }
}

// An edge is known at both ends, loop by loop.
TEST_P(Crossing_loops, AreKnownAtTheVerticesBesideThem) {
  const std::vector<Crossing_loop> loops = random_loops(mesh, random, 10);
  const Crossing_index index(mesh, loops);
  std::vector<std::vector<std::array<Index, 3>>> expected(mesh.number_of_vertices());
  for(Index j = 0; j < loops.size(); ++j)
    for(const Crossing& c : loops[j]) {
      expected[c.left].push_back({c.right, j, 1});
      expected[c.right].push_back({c.left, j, 0});
    }
  const std::vector<Index> begins = index.begins_of_all();
  ASSERT_EQ(begins.size(), mesh.number_of_vertices() + 1);
  EXPECT_EQ(begins.back(), index.entries().size());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const auto entries = index.entries_at(v);
    EXPECT_EQ(index.has_crossing(v), !expected[v].empty());
    ASSERT_EQ(entries.size(), expected[v].size());
    ASSERT_EQ(begins[v + 1] - begins[v], entries.size());
    for(std::size_t i = 0; i < entries.size(); ++i) {
      const auto& e = entries[i];
      EXPECT_EQ((std::array<Index, 3>{e.other, e.loop, e.sign == 1 ? 1u : 0u}), expected[v][i]);
      EXPECT_EQ(index.entries()[begins[v] + i].other, e.other);
    }
  }
}

TEST_P(Crossing_loops, AreWallsWhereTheyCross) {
  const std::vector<Crossing_loop> loops = random_loops(mesh, random, 4);
  const Crossing_index index(mesh, loops);
  const Loops_from late = {2};
  const Loop_walls<Loops_from> walls(index, late);
  std::set<std::pair<Index, Index>> crossed;
  for(std::size_t j = 2; j < loops.size(); ++j)
    for(const Crossing& c : loops[j])
      crossed.insert({{c.left, c.right}, {c.right, c.left}});
  for(Index u = 0; u < mesh.number_of_vertices(); ++u)
    for(const Index v : mesh.ring(u))
      EXPECT_EQ(walls.is_wall(u, v), crossed.count({u, v}) != 0);
}

TEST_P(Crossing_loops, HaveAClosedWalkOnTheirLeft) {
  for(const Crossing_loop& loop : random_loops(mesh, random, 20)) {
    std::vector<std::pair<Index, Index>> edges;
    for_each_left_edge(loop, [&](Index u, Index v) { edges.emplace_back(u, v); });
    for(std::size_t i = 0; i < edges.size(); ++i) {
      const auto [u, v] = edges[i];
      EXPECT_LT(mesh.ring(u).position(v), mesh.ring(u).size());
      EXPECT_EQ(v, edges[(i + 1) % edges.size()].first);
    }
  }
}

TEST(Circles_of_torus, CrossOnce) {
  const Flat_mesh torus = flat_mesh_of({"torus", {2000, 1, 0}});
  const std::vector<Crossing_loop> loops = {loop_around_tube(torus, 0.3),
                                            loop_around_hole(torus, 0.3)};
  const Integer_matrix matrix = intersection_matrix(loops, Crossing_index(torus, loops), 2);
  EXPECT_EQ(abs(matrix[0][1]), 1);
  EXPECT_EQ(determinant(matrix), 1);
}

// By trying all pairs of crossings.
double
least_way(const Crossing_loop& loop, const std::vector<double>& along, Index from, Index to) {
  double least = 2. * along.back() + 1.;
  for(std::size_t i = 0; i < loop.size(); ++i)
    for(std::size_t j = 0; j < loop.size(); ++j)
      if(loop[i].left == from && loop[j].right == to) {
        const double one_way = std::abs(along[i] - along[j]);
        least = (std::min)(least, (std::min)(one_way, along.back() - one_way));
      }
  return least;
}

TEST_P(Crossing_loops, HaveAShorterArcBetweenEnds) {
  using CGAL::Handle_tunnel_loops::internal::Shorter_arc;
  for(const Crossing_loop& loop : random_loops(mesh, random, 20)) {
    if(loop.empty())
      continue;
    std::vector<double> along;
    CGAL::Handle_tunnel_loops::internal::measure_left_side(mesh, loop, along);
    Shorter_arc arc(loop.data(), static_cast<Index>(loop.size()), along.data());
    EXPECT_FALSE(arc.find(&Crossing::left, Index(-2), &Crossing::right, loop[0].right));
    for(int i = 0; i < 20; ++i) {
      const Index from = loop[random.below(loop.size())].left,
                  to = loop[random.below(loop.size())].right;
      ASSERT_TRUE(arc.find(&Crossing::left, from, &Crossing::right, to));
      double way = 0.;
      const Crossing *first = nullptr, *last = nullptr;
      arc.for_each([&](const Crossing& c) {
        way += last == nullptr || last->left == c.left ? 0. : mesh.edge_length(last->left, c.left);
        first = first == nullptr ? &c : first;
        last = &c;
      });
      EXPECT_EQ(first->left, from);
      EXPECT_EQ(last->right, to);
      EXPECT_NEAR(way, least_way(loop, along, from, to), 1e-12 * along.back());
    }
  }
}

TEST(Empty_loop, MeetsNothing) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {100, 1, 0}});
  Random random(2);
  const Crossing_index index(mesh, random_loops(mesh, random, 5));
  EXPECT_TRUE(index.intersections(Crossing_loop()).empty());
  EXPECT_TRUE(index.intersections(Vertex_walk()).empty());
  EXPECT_EQ(length(mesh, Crossing_loop()), 0.);
  EXPECT_TRUE(pushed_left(mesh, {}).empty());
  Crossing_loop empty;
  remove_backtracks(empty);
  EXPECT_TRUE(empty.empty());
}

} // namespace test_crossing_loops
