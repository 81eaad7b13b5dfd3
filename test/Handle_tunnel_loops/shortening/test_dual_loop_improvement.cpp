// A second look finds the short loops again where there are long ones of the same pairs, and leaves
// a basis.

#include "Quiet_progress.h"
#include "Torus_loops.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Dual_loop_improvement.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace test_dual_loop_improvement {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::Statistics;

// Pairs that are a basis, on a connected surface.
struct Pairs
{
  explicit Pairs(const Flat_mesh& m)
      : mesh(m) {
    Quiet_progress progress;
    Statistics statistics;
    Pass_options options;
    options.do_tighten = false;
    const auto passes = Passes_of_tag<CGAL::Sequential_tag>::make(mesh, {0}, options);
    for(Flat_pair& pair : run_passes(*passes, options, progress, statistics)) {
      handles.push_back(std::move(pair.handle));
      tunnels.push_back(std::move(pair.tunnel));
    }
    tighten();
  }

  void tighten() {
    for(auto* loops : {&handles, &tunnels})
      for(Crossing_loop& loop : *loops)
        Loop_tightening(mesh).tighten(loop);
  }

  // Each tunnel goes some more times around its handle.
  void twist(int times) {
    for(std::size_t k = 0; k < tunnels.size(); ++k)
      tunnels[k] = sum(tunnels[k], handles[k], times);
    tighten();
  }

  void look_again() {
    Quiet_progress progress;
    Dual_loop_improvement(Execution(), mesh, progress).improve(handles, tunnels);
  }

  std::vector<Crossing_loop> loops() const {
    std::vector<Crossing_loop> all = handles;
    all.insert(all.end(), tunnels.begin(), tunnels.end());
    return all;
  }

  std::vector<double> lengths() const {
    std::vector<double> result;
    for(const Crossing_loop& loop : loops())
      result.push_back(length(mesh, loop));
    return result;
  }

  double length_of_tunnels() const {
    double sum = 0.;
    for(const Crossing_loop& loop : tunnels)
      sum += length(mesh, loop);
    return sum;
  }

  // With all loops to the left of them; the sign is that of a symplectic matrix.
  Integer determinant_of_intersections() const {
    const std::vector<Crossing_loop> all = loops();
    return determinant(intersection_matrix(all, Crossing_index(mesh, all), all.size()));
  }

  const Flat_mesh& mesh;
  std::vector<Crossing_loop> handles, tunnels;

private:
  // From a common vertex of their left sides along one and then some times along the other.
  Crossing_loop sum(const Crossing_loop& a, const Crossing_loop& b, int times) const {
    Vertex_walk walk = left_walk(a), other = left_walk(b);
    const auto start = std::find_first_of(walk.begin(), walk.end(), other.begin(), other.end());
    EXPECT_NE(start, walk.end()) << "the loops do not cross";
    std::rotate(walk.begin(), start, walk.end());
    std::rotate(other.begin(), std::find(other.begin(), other.end(), walk.front()), other.end());
    for(int i = 0; i < times; ++i)
      walk.insert(walk.end(), other.begin(), other.end());
    remove_spurs(walk);
    return pushed_left(mesh, walk);
  }

  static Vertex_walk left_walk(const Crossing_loop& loop) {
    Vertex_walk walk;
    for(const Crossing& c : loop)
      walk.push_back(c.left);
    return walk;
  }
};

void expect_improvement(Pairs& pairs) {
  const std::vector<double> before = pairs.lengths();
  pairs.look_again();
  const std::vector<double> after = pairs.lengths();
  for(std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LE(after[i], before[i]) << "loop " << i;
  for(const Crossing_loop& loop : pairs.loops())
    expect_crossing_loop(pairs.mesh, loop);
  EXPECT_EQ(pairs.determinant_of_intersections(), 1);
}

TEST(Dual_loop_improvement, TakesTwistsOutOfATunnel) {
  const Flat_mesh torus = flat_mesh_of({"torus", {8000, 1, 0}});
  for(const int times : {1, 3}) {
    SCOPED_TRACE(testing::Message() << times << " times");
    Pairs pairs(torus);
    pairs.twist(times);
    ASSERT_GT(pairs.length_of_tunnels(), 1.05 * 2. * pi * inner_radius);
    expect_improvement(pairs);
    EXPECT_NEAR(pairs.length_of_tunnels(), 2. * pi * inner_radius, 0.01 * 2. * pi * inner_radius);
  }
}

// Not every twist is found: the shortest way may be in a class that is not the tunnel's.
TEST(Dual_loop_improvement, KeepsABasisOnAllKindsOfSurfaces) {
  double twisted = 0., improved = 0.;
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3, 10}, 2)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Pairs pairs(mesh);
    expect_improvement(pairs);
    const double good = pairs.length_of_tunnels();
    pairs.twist(2);
    twisted += pairs.length_of_tunnels() / good;
    expect_improvement(pairs);
    improved += pairs.length_of_tunnels() / good;
  }
  EXPECT_LT(improved, 0.8 * twisted);
}

TEST(Dual_loop_improvement, KeepsABasisOnRandomSurfaces) {
  Random random(1);
  double twisted = 0., improved = 0.;
  for(int i = 0; i < 60; ++i) {
    const Recipe recipe = random_recipe(random, 8);
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Pairs pairs(mesh);
    pairs.twist(1 + i % 3);
    twisted += pairs.length_of_tunnels();
    expect_improvement(pairs);
    improved += pairs.length_of_tunnels();
  }
  EXPECT_LT(improved, 0.8 * twisted);
}

// The whole search, by its definition: Dijkstra's algorithm from one vertex at a time.
class Brute_force
{
public:
  Brute_force(const Flat_mesh& mesh, const Crossing_index& index, Index k)
      : mesh_(mesh)
      , index_(index)
      , barred_{k} {}

  /// the lengths of the shortest paths from `source` that do not cross the loop.
  std::vector<double> distances(Index source) const {
    std::vector<double> distance(mesh_.number_of_vertices(), 1e9);
    distance[source] = 0.;
    for(bool changed = true; changed;) {
      changed = false;
      for(Index v = 0; v < distance.size(); ++v)
        for(const Index u : mesh_.ring(v))
          if(!index_.is_crossed(v, u, barred_) &&
             distance[v] + mesh_.edge_length(v, u) < distance[u] - 1e-9) {
            distance[u] = distance[v] + mesh_.edge_length(v, u);
            changed = true;
          }
    }
    return distance;
  }

private:
  const Flat_mesh& mesh_;
  const Crossing_index& index_;
  Only_loop barred_;
};

double length_of_walk(const Flat_mesh& mesh, const Vertex_walk& walk) {
  double sum = 0.;
  for(std::size_t i = 0; i < walk.size(); ++i)
    sum += mesh.edge_length(walk[i], walk[(i + 1) % walk.size()]);
  return sum;
}

double longest_edge_across(const Flat_mesh& mesh, const Crossing_loop& loop) {
  double longest = 0.;
  for(const Crossing& c : loop)
    longest = (std::max)(longest, mesh.edge_length(c.left, c.right));
  return longest;
}

// No walk that crosses the loop once is shorter than the shortest way from the left side of a
// crossing to the right side of one; and one that is found is at most longer than that by half of
// the loop.
TEST(Bidirectional_dijkstra, FindsAShortWay) {
  Random random(2);
  int number_found = 0;
  for(int i = 0; i < 40; ++i) {
    const Recipe recipe = random_recipe(random, 4);
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Pairs pairs(mesh);
    const Crossing_index index(mesh, pairs.handles);
    Bidirectional_dijkstra search(mesh);
    for(Index k = 0; k < pairs.handles.size(); ++k) {
      const Crossing_loop& loop = pairs.handles[k];
      double shortest = 1e9, along = 0.;
      Index previous = loop.back().left;
      for(const Crossing& c : loop) {
        const auto distance = Brute_force(mesh, index, k).distances(c.left);
        for(const Crossing& d : loop)
          shortest = (std::min)(shortest, distance[d.right]);
        along += mesh.edge_length(previous, c.left);
        previous = c.left;
      }
      const Vertex_walk walk = search.dual_walk(loop, k, index, 1e9, 1000000);
      if(walk.empty())
        continue; // the loop is so long that a vertex lies on both sides of it
      ++number_found;
      for(std::size_t j = 0; j < walk.size(); ++j)
        ASSERT_LT(mesh.ring(walk[j]).position(walk[(j + 1) % walk.size()]),
                  mesh.ring(walk[j]).size());
      EXPECT_TRUE(is_dual(index.intersections(walk), k, Only_loop{k}));
      const double found = length_of_walk(mesh, walk);
      EXPECT_LE(found, shortest + 0.5 * along + longest_edge_across(mesh, loop) + 1e-5);
      EXPECT_EQ(search.dual_walk(loop, k, index, 1e9, 1000000), walk)
          << "the workspace remembers the last search";
      EXPECT_TRUE(search.dual_walk(loop, k, index, 0.5 * shortest, 1000000).empty());
      EXPECT_TRUE(search.dual_walk(loop, k, index, 1e9, 0).empty());
    }
  }
  EXPECT_GT(number_found, 40);
}

} // namespace test_dual_loop_improvement
