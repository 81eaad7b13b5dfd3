// Few and short curves of the class of a sum of loops: they have its class, and are much shorter
// than the loops one after the other.

#include "Loops_of_classes.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Level_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sum.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace test_level_curves {

using namespace CGAL::Handle_tunnel_loops::internal;

const std::vector<Recipe> connected = {
    {"torus", {160, 1, 0}},    {"multi-torus", {600, 2, 0}}, {"sponge", {160, 3, 0}},
    {"lattice", {1200, 3, 1}}, {"plates", {1200, 2, 0}},     {"gyroid", {2000, 3, 0}},
    {"random", {60, 1, 0}},    {"random", {80, 2, 1}},       {"random", {120, 3, 2}}};

TEST(Level_curves, HaveTheClassOfASum) {
  Random random(1);
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::vector<Crossing_loop> loops = loops_of_basis(soup_of(recipe));
    const Loop_classes classes(Execution(), mesh, loops);
    for(const Class_vector& a : wound_up(random, loops.size(), 40, 20)) {
      const Level_curves level(mesh, loops, a);
      Class_vector numbers;
      std::int64_t crossings = 0;
      for(const Crossing_loop& curve : level.curves()) {
        expect_crossing_loop(mesh, curve);
        const Class_vector of_curve = classes.numbers(curve);
        numbers.insert(numbers.end(), of_curve.begin(), of_curve.end());
        crossings += static_cast<std::int64_t>(curve.size());
      }
      normalize(numbers);
      EXPECT_EQ(numbers, classes.numbers_of_class(a));
      EXPECT_LE(crossings, level.number_of_crossings());
    }
  }
}

// Each loop there and back, and each edge of it in another place.
TEST(Level_curves, AreNoneOfWhatCancels) {
  const Recipe recipe = {"lattice", {1200, 3, 1}};
  const Flat_mesh mesh = flat_mesh_of(recipe);
  std::vector<Crossing_loop> loops = loops_of_basis(soup_of(recipe));
  const std::size_t n = loops.size();
  for(std::size_t i = 0; i < n; ++i)
    loops.push_back(pushed_left(mesh, [&] {
      Vertex_walk walk;
      for(const Crossing& c : loops[i])
        walk.push_back(c.right);
      remove_spurs(walk);
      return walk;
    }()));
  Class_vector a;
  for(Index i = 0; i < n; ++i) {
    a.emplace_back(i, 3);
    a.emplace_back(Index(i + n), -3);
  }
  normalize(a);
  const Level_curves level(mesh, loops, a);
  EXPECT_EQ(level.number_of_crossings(), 0);
  EXPECT_TRUE(level.curves().empty());
}

// A basis is wound up, and what it was is put together of very many loops that all but cancel each
// other.
TEST(Loop_sum, OfManyLoopsThatCancelIsShort) {
  Random random(2);
  for(const Recipe& recipe : {Recipe{"sponge", {1500, 9, 0}}, Recipe{"gyroid", {6000, 12, 0}}}) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::vector<Crossing_loop> loops = loops_of_basis(soup_of(recipe));
    const std::vector<Crossing_loop> longer =
        combined(mesh, loops, wound_up(random, loops.size(), 100, 3));
    const Loop_classes classes(Execution(), mesh, longer);
    double before = 0.;
    std::size_t after = 0;
    for(const Crossing_loop& loop : loops) {
      const Class_vector numbers = classes.numbers(loop);
      const std::optional<Class_vector> a = classes.class_with(numbers);
      ASSERT_TRUE(a);
      const Crossing_loop sum = Loop_sum(mesh, longer).loop(*a);
      expect_crossing_loop(mesh, sum);
      EXPECT_EQ(classes.numbers(sum), numbers);
      before += crossings_of_sum(longer, *a);
      after += sum.size();
    }
    EXPECT_LT(double(after), before / 8.);
  }
}

} // namespace test_level_curves
