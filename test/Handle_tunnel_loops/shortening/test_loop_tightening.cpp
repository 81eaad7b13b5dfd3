// Tightened, a loop is never longer than before, in the same class, and a circle where that is
// known; test_geodesics.cpp is about its angles.

#include "Crossing_loops.h"
#include "Surfaces_for_loops.h"
#include "Torus_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace test_loop_tightening {

using CGAL::Handle_tunnel_loops::internal::Crossing;
using CGAL::Handle_tunnel_loops::internal::Execution;
using CGAL::Handle_tunnel_loops::internal::length;
using CGAL::Handle_tunnel_loops::internal::Loop_tightening;
using CGAL::Handle_tunnel_loops::internal::pushed_left;
using CGAL::Handle_tunnel_loops::internal::remove_spurs;

bool is_same(const Crossing& a, const Crossing& b) {
  return a.left == b.left && a.right == b.right && a.ratio == b.ratio;
}

// Goes on around the left end of the last crossing, and comes back to the same edge.
void append_turns_around_left(const Flat_mesh& mesh, int turns, Crossing_loop& loop) {
  const Crossing first = loop.back();
  const auto ring = mesh.ring(first.left);
  for(; turns > 0; --turns)
    for(Index i = 0, p = ring.position(first.right); i < ring.size(); ++i) {
      p = ring.next(p);
      loop.push_back({first.left, ring[p], first.ratio});
    }
}

// The class is seen through the intersection numbers with a fixed family.
void expect_tightened(const Flat_mesh& mesh,
                      const Crossing_loop& loop,
                      const Crossing_index& index) {
  for(const int rounds : {1, 3, 100}) {
    Crossing_loop taut = loop;
    Loop_tightening(mesh).tighten(taut, rounds);
    expect_crossing_loop(mesh, taut);
    EXPECT_LE(length(mesh, taut), (1. + 1e-12) * length(mesh, loop));
    EXPECT_EQ(index.intersections(taut), index.intersections(loop));
  }
}

void expect_tightened(const Flat_mesh& mesh, unsigned seed) {
  Random random(seed);
  const Crossing_index index(mesh, random_loops(mesh, random, 20));
  for(const Crossing_loop& loop : random_loops(mesh, random, 30))
    expect_tightened(mesh, loop, index);
}

TEST(Tightening, KeepsTheClassOnSmoothSurfaces) {
  for_each_smooth_surface(
      [](const Flat_mesh& mesh, unsigned seed) { expect_tightened(mesh, seed); });
}

TEST(Tightening, KeepsTheClassOnRandomSurfaces) {
  for_each_random_surface(
      [](const Flat_mesh& mesh, unsigned seed) { expect_tightened(mesh, seed); });
}

// Edges without length, triangles without area: nothing is gained, but it ends.
TEST(Tightening, EndsWherePointsCoincide) {
  for_each_surface_with_coinciding_points(
      [](const Flat_mesh& mesh, unsigned seed) { expect_tightened(mesh, seed); });
}

// Through one random vertex after the other, along at least so many edges.
Crossing_loop long_loop(const Flat_mesh& mesh, Random& random, std::size_t edges) {
  const auto random_vertex = [&] { return static_cast<Index>(random.below(mesh.first_hub)); };
  const Index first = random_vertex();
  Vertex_walk walk;
  Index last = first;
  const auto append_way = [&](Index next) {
    const Vertex_walk way = path(mesh, last, next);
    walk.insert(walk.end(), way.begin(), way.end());
    last = next;
  };
  while(walk.size() < edges)
    append_way(random_vertex());
  append_way(first);
  remove_spurs(walk);
  return pushed_left(mesh, walk);
}

// A long loop is tightened in arcs, side by side: the same in one thread and in many.
TEST(Tightening, KeepsTheClassOfLongLoopsInAnyNumberOfThreads) {
  Random random(11);
  for(const Recipe& recipe : {Recipe{"torus", {20000, 1, 0}}, Recipe{"gyroid", {20000, 5, 0}},
                              Recipe{"random", {3000, 4, 2}}, Recipe{"lattice", {2000, 3, 0}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Crossing_index index(mesh, random_loops(mesh, random, 20));
    const Crossing_loop loop = long_loop(mesh, random, 1500);
    Crossing_loop one = loop, many = loop;
    Loop_tightening(mesh).tighten(one, 300);
    Loop_tightening(Execution::parallel(), mesh).tighten(many, 300);
    expect_crossing_loop(mesh, one);
    EXPECT_LT(length(mesh, one), 0.9 * length(mesh, loop));
    EXPECT_EQ(index.intersections(one), index.intersections(loop));
    EXPECT_TRUE(std::equal(one.begin(), one.end(), many.begin(), many.end(), is_same));
  }
}

// That arcs are tightened first takes nothing from the whole.
TEST(Tightening, FindsTheCircleAlongManyEdges) {
  const Flat_mesh torus = flat_mesh_of({"torus", {500000, 1, 0}});
  Crossing_loop loop = loop_around_hole(torus, 1.);
  ASSERT_GT(loop.size(), 2048u);
  Loop_tightening(Execution::parallel(), torus).tighten(loop, 100);
  EXPECT_NEAR(length(torus, loop), 2. * pi * inner_radius, 0.001 * 2. * pi * inner_radius);
}

TEST(Tightening, FindsTheCircleAroundATube) {
  const Flat_mesh torus = flat_mesh_of({"torus", {8000, 1, 0}});
  for(const double swing : {0.1, 0.4, 0.8}) {
    SCOPED_TRACE(testing::Message() << "swing " << swing);
    Crossing_loop loop = loop_around_tube(torus, swing);
    ASSERT_GT(length(torus, loop), 1.2 * 2. * pi * tube_radius);
    Loop_tightening(torus).tighten(loop, 1000);
    EXPECT_NEAR(length(torus, loop), 2. * pi * tube_radius, 0.01 * 2. * pi * tube_radius);
  }
}

TEST(Tightening, FindsTheCircleAroundAHole) {
  const Flat_mesh torus = flat_mesh_of({"torus", {8000, 1, 0}});
  for(const double swing : {0.2, 0.5, 1.}) {
    SCOPED_TRACE(testing::Message() << "swing " << swing);
    Crossing_loop loop = loop_around_hole(torus, swing);
    ASSERT_GT(length(torus, loop), 1.1 * 2. * pi * inner_radius);
    Loop_tightening(torus).tighten(loop, 1000);
    EXPECT_NEAR(length(torus, loop), 2. * pi * inner_radius, 0.01 * 2. * pi * inner_radius);
  }
}

// A loop that shares work with many has fewer rounds, but one at least.
TEST(Tightening, SharesItsWork) {
  const Flat_mesh torus = flat_mesh_of({"torus", {8000, 1, 0}});
  const Crossing_loop loop = loop_around_hole(torus, 0.5);
  const auto length_among = [&](double work) {
    Crossing_loop tight = loop;
    Loop_tightening(torus).tighten_among(tight, work, double(loop.size()));
    return length(torus, tight);
  };
  Crossing_loop alone = loop, once = loop;
  Loop_tightening(torus).tighten(alone);
  Loop_tightening(torus).tighten(once, 1);
  EXPECT_EQ(length_among(200. * double(loop.size())), length(torus, alone));
  EXPECT_EQ(length_among(0.), length(torus, once));
  EXPECT_LT(length_among(2. * double(loop.size())), length(torus, once));
  EXPECT_GT(length_among(2. * double(loop.size())), length(torus, alone));
}

TEST(Tightening, GainsLittleTheSecondTime) {
  const Flat_mesh torus = flat_mesh_of({"torus", {3000, 1, 0}});
  Crossing_loop loop = loop_around_tube(torus, 0.5);
  Loop_tightening tightening(torus);
  tightening.tighten(loop, 1000);
  const double once = length(torus, loop);
  tightening.tighten(loop, 1000);
  EXPECT_GT(length(torus, loop), 0.99 * once);
}

// The paths across the vertex are shorter than those around it, and there is nothing to hold the
// loop.
TEST(Tightening, EndsWithAContractibleLoop) {
  for(const Recipe& recipe :
      {Recipe{"sphere", {500, 0, 0}}, Recipe{"torus", {500, 1, 0}}, Recipe{"random", {200, 3, 1}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Random random(3);
    const Crossing_index index(mesh, random_loops(mesh, random, 10));
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const auto ring = mesh.ring(v);
      const Vertex_walk around(ring.begin(), ring.end());
      ASSERT_TRUE(index.intersections(around).empty());
      expect_tightened(mesh, pushed_left(mesh, around), index);
      expect_tightened(mesh, pushed_left(mesh, {around.rbegin(), around.rend()}), index);
    }
  }
}

// However often it goes around the vertex.
TEST(Tightening, MakesTurnsAroundAVertexAPoint) {
  Random random(4);
  int points = 0, all = 0;
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    for(int i = 0; i < 50; ++i) {
      const auto ring = mesh.ring(static_cast<Index>(random.below(mesh.number_of_vertices())));
      Vertex_walk around;
      for(std::size_t turns = 1 + random.below(4); turns > 0; --turns)
        around.insert(around.end(), ring.begin(), ring.end());
      Crossing_loop inside = pushed_left(mesh, around),
                    outside = pushed_left(mesh, {around.rbegin(), around.rend()});
      Loop_tightening(mesh).tighten(inside);
      EXPECT_TRUE(inside.empty()) << inside.size() << " crossings";
      Loop_tightening(mesh).tighten(outside);
      points += outside.empty();
      ++all;
    }
  }
  EXPECT_GE(points, 0.9 * all) << points << " of " << all;
}

// A turn is put where a loop passes a vertex. Nothing of it is seen afterwards.
TEST(Tightening, TakesOutTurns) {
  using CGAL::Handle_tunnel_loops::internal::remove_turns;
  Random random(5);
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    for(Crossing_loop expected : random_loops(mesh, random, 20)) {
      remove_turns(mesh, expected);
      if(expected.empty())
        continue;
      Crossing_loop loop;
      const std::size_t place = random.below(expected.size());
      for(std::size_t i = 0; i < expected.size(); ++i) {
        loop.push_back(expected[i]);
        if(i == place)
          append_turns_around_left(mesh, 1 + static_cast<int>(random.below(3)), loop);
      }
      expect_crossing_loop(mesh, loop);
      remove_turns(mesh, loop);
      EXPECT_TRUE(std::equal(loop.begin(), loop.end(), expected.begin(), expected.end(), is_same));
    }
  }
}

TEST(Tightening, LeavesAnEmptyLoopAlone) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {100, 1, 0}});
  Crossing_loop loop;
  Loop_tightening(mesh).tighten(loop);
  EXPECT_TRUE(loop.empty());
}

// A circle around a solid tube grows by 2 pi when the surface is moved outwards, one around the
// hole shrinks as much, whichever way the faces look.
TEST(Growth, IsThatOfCircles) {
  using CGAL::Handle_tunnel_loops::internal::Offset_growth;
  Soup soup = soup_of({"torus", {8000, 1, 0}});
  for(const bool looks_inwards : {false, true}) {
    if(looks_inwards)
      reverse_orientation(soup);
    const Flat_mesh torus = flat_mesh_of(soup);
    Crossing_loop tube = loop_around_tube(torus, 0.1), hole = loop_around_hole(torus, 0.2);
    Loop_tightening(torus).tighten(tube, 1000);
    Loop_tightening(torus).tighten(hole, 1000);
    EXPECT_NEAR(Offset_growth(torus)(tube), 2. * pi, 0.1);
    EXPECT_NEAR(Offset_growth(torus)(hole), -2. * pi, 0.1);
  }
}

} // namespace test_loop_tightening
