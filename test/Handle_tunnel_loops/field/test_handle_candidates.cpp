// Whatever the order in which a surface is swept, as long as every vertex but the first has an
// earlier neighbour, as many handles are found as there are.

#include "Crossing_loops.h"
#include "Lower_components.h"
#include "Random_growth.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace test_handle_candidates {

using namespace CGAL::Handle_tunnel_loops::internal;

const auto execution = Execution();

TEST(Contour_crossing, IsWhereTheTimeIsThatOfTheContour) {
  Random random(8);
  for(int i = 0; i < 1000; ++i) {
    const auto time = [&] { return static_cast<Time>(random.below(i < 500 ? 10 : 100000)); };
    const Time left = time(), right = left + time(), at = left + time();
    if(at > right)
      continue;
    const Crossing c = contour_crossing(3, 5, left, right, at);
    EXPECT_TRUE(c.left == 3 && c.right == 5);
    EXPECT_GE(c.ratio, smallest_ratio);
    EXPECT_LE(c.ratio, largest_ratio);
    const double found = left + c.ratio * (double(right) - left), width = double(right) - left;
    EXPECT_NEAR(found, at, left == right ? 0. : (smallest_ratio + 1e-12) * width);
    if(c.ratio > smallest_ratio && c.ratio < largest_ratio) {
      EXPECT_NEAR(found, at, 1e-12 * width);
    }
  }
}

void expect_disjoint(const Flat_mesh& mesh, const std::vector<Handle_candidate>& handles) {
  std::vector<Crossing_loop> loops;
  for(const Handle_candidate& handle : handles)
    loops.push_back(handle.loop);
  const Crossing_index index(mesh, loops);
  for(const Crossing_loop& loop : loops)
    EXPECT_TRUE(index.intersections(loop).empty());
}

// With the handles as rows and columns in the order of the sweep, the matrix is triangular.
void expect_triangular_pairing(const Flat_mesh& mesh,
                               const Arrival_order& order,
                               const std::vector<Handle_candidate>& handles) {
  std::vector<Crossing_loop> loops, tunnels;
  for(const Handle_candidate& handle : handles) {
    loops.push_back(handle.loop);
    tunnels.push_back(descending_tunnel(mesh, order, handle));
    expect_crossing_loop(mesh, tunnels.back());
  }
  const Integer_matrix matrix =
      intersection_matrix(tunnels, Crossing_index(mesh, loops), loops.size());
  for(std::size_t i = 0; i < loops.size(); ++i) {
    EXPECT_EQ(abs(matrix[i][i]), 1);
    for(std::size_t j = i + 1; j < loops.size(); ++j)
      EXPECT_EQ(matrix[i][j], 0) << "tunnel " << i << " crosses the later handle " << j;
  }
}

void expect_handles(const Flat_mesh& mesh, const std::vector<Time>& times) {
  const Arrival_order order(times);
  const std::vector<Handle_candidate> handles = find_handle_candidates(execution, mesh, times);
  ASSERT_EQ(handles.size(), mesh.genus);
  for(std::size_t k = 0; k < handles.size(); ++k) {
    const Handle_candidate& handle = handles[k];
    expect_crossing_loop(mesh, handle.loop);
    EXPECT_FALSE(order.is_earlier(handle.saddle, handles[k == 0 ? 0 : k - 1].saddle));
    for(const Index foot : {handle.foot_a, handle.foot_b}) {
      EXPECT_TRUE(order.is_earlier(foot, handle.saddle));
      EXPECT_LT(mesh.ring(handle.saddle).position(foot), mesh.ring(handle.saddle).size());
    }
    // Just below a simple saddle, with what was swept on the left.
    if(number_of_lower_components(mesh, times, handle.saddle) == 2)
      for(const Crossing& c : handle.loop) {
        EXPECT_TRUE(order.is_earlier(c.left, handle.saddle));
        EXPECT_FALSE(order.is_earlier(c.right, handle.saddle));
      }
  }
  expect_disjoint(mesh, handles);
  expect_triangular_pairing(mesh, order, handles);
}

TEST(Sweep, FindsAllHandlesInAnyOrder) {
  Random random(1);
  Index lower_components = 0;
  for(int i = 0; i < 1500; ++i) {
    const Recipe recipe = random_recipe(random, 11);
    const std::size_t width = i % 3 == 0 ? 1 : 1 + random.below(100);
    SCOPED_TRACE(testing::Message() << recipe << ", front of " << width);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Random_growth growth(mesh, random, width);
    expect_handles(mesh, growth.times());
    lower_components = (std::max)(lower_components, most_lower_components(mesh, growth.times()));
  }
  EXPECT_GE(lower_components, 5u) << "the meshes are too harmless";
}

TEST(Sweep, FindsAllHandlesOfSmoothSurfaces) {
  Random random(2);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2, 5}, 1)) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    for(const std::size_t width : {1, 10, 100000}) {
      SCOPED_TRACE(testing::Message() << recipe << ", front of " << width);
      expect_handles(mesh, Random_growth(mesh, random, width).times());
    }
  }
}

// All 5040 orders of the vertices of the smallest torus. All vertices are neighbours, so each
// order has one minimum.
TEST(Sweep, FindsTheHandleOfTheSmallestTorusInEveryOrder) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  std::vector<Time> times(7);
  std::iota(times.begin(), times.end(), 0u);
  int number_of_monkey_saddles = 0;
  do {
    SCOPED_TRACE(testing::PrintToString(times));
    expect_handles(mesh, times);
    number_of_monkey_saddles += most_lower_components(mesh, times) == 3;
  } while(std::next_permutation(times.begin(), times.end()));
  EXPECT_GT(number_of_monkey_saddles, 0);
}

// A torus with a minimum, a maximum and one critical point between them: one contour comes to it,
// one contour leaves it, and there is a handle all the same.
TEST(Monkey_saddle, HidesAHandle) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  std::vector<Time> times(7);
  std::iota(times.begin(), times.end(), 0u);
  int number_of_saddles = 0;
  do {
    Processor_executor executor(execution);
    Saddle_contours<Processor_executor> saddles(executor, view_of(mesh),
                                                {times.data(), times.size()});
    if(saddles.keys().size() != 1)
      continue;
    ++number_of_saddles;
    const std::vector<Lower_component_arc> arcs = saddles.lower_components();
    ASSERT_EQ(arcs.size(), 3u);
    // Below, an arc goes on from the lower component at which it arrives, above from the one after
    // it.
    for(const Index shift : {0u, 1u}) {
      Index at = 0;
      std::set<Index> visited;
      while(visited.insert(at).second)
        at = (arcs[at].arrival + shift) % 3;
      EXPECT_EQ(visited.size(), 3u);
    }
    EXPECT_EQ(saddles.handles().size(), 1u);
  } while(std::next_permutation(times.begin(), times.end()));
  EXPECT_GT(number_of_saddles, 0);
}

// Equal times are told apart by number.
TEST(Arrival_order, IsTotal) {
  const std::vector<Time> times = {5, 3, 5, 3, never};
  const Arrival_order order(times);
  std::vector<Index> vertices = {0, 1, 2, 3, 4};
  std::sort(vertices.begin(), vertices.end(),
            [&](Index u, Index v) { return order.is_earlier(u, v); });
  EXPECT_EQ(vertices, (std::vector<Index>{1, 3, 0, 2, 4}));
  for(const Index v : vertices)
    EXPECT_FALSE(order.is_earlier(v, v));
}

TEST(Descent, EndsAtTheSource) {
  Random random(3);
  const Flat_mesh mesh = flat_mesh_of({"multi-torus", {1500, 3, 0}});
  const Random_growth growth(mesh, random, 50);
  const Arrival_order order(growth.times());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const std::vector<Index> walk = descent(mesh, order, v);
    EXPECT_EQ(walk.front(), v);
    EXPECT_EQ(order.time(walk.back()), 0u);
    for(std::size_t i = 0; i + 1 < walk.size(); ++i)
      EXPECT_TRUE(order.is_earlier(walk[i + 1], walk[i]));
  }
}

} // namespace test_handle_candidates
