// Tightened, loops become closed geodesics: as long as these where they are known, and everywhere
// without bends that could be taken out.

#include "Crossing_loops.h"
#include "Flat_torus.h"
#include "Geodesic_angles.h"
#include "Torus_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/shortening/Gauss_reduction.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_geodesics {

using CGAL::Handle_tunnel_loops::internal::length;
using CGAL::Handle_tunnel_loops::internal::Loop_tightening;
using CGAL::Handle_tunnel_loops::internal::pushed_left;
using geodesic_angles::Largest_bend;

// A closed walk through a few places that passes no vertex twice.
Vertex_walk random_simple_walk(const Flat_mesh& mesh, Random& random) {
  for(;;) {
    std::vector<Index> places;
    for(std::size_t i = 2 + random.below(4); i > 0; --i)
      places.push_back(static_cast<Index>(random.below(mesh.number_of_vertices())));
    Vertex_walk walk;
    for(std::size_t i = 0; i < places.size(); ++i) {
      const Vertex_walk part = path(mesh, places[i], places[(i + 1) % places.size()]);
      walk.insert(walk.end(), part.begin(), part.end());
    }
    CGAL::Handle_tunnel_loops::internal::remove_spurs(walk);
    if(walk.size() >= 3 && std::set<Index>(walk.begin(), walk.end()).size() == walk.size())
      return walk;
  }
}

// Until nothing is gained: one call may leave a small bend where it held the path last.
Crossing_loop taut(const Flat_mesh& mesh, Crossing_loop loop) {
  Loop_tightening tightening(mesh);
  for(double before = 2. * length(mesh, loop) + 1.; length(mesh, loop) < (1. - 1e-12) * before;) {
    before = length(mesh, loop);
    tightening.tighten(loop);
  }
  return loop;
}

// A few loops keep a bend: a small one on a plane, where nearly nothing is to be gained by it, and
// where an edge is shorter than 1e-9 and rounding turns what is laid out behind it.
constexpr double tolerance = 1e-6;

TEST(Geodesic, OnAFlatTorusIsAStraightLine) {
  Random random(1);
  std::map<std::pair<int, int>, int> count;
  int bent = 0, all = 0;
  for(int round = 0; round < 100; ++round) {
    const double height = random.uniform(0.3, 3.);
    const Flat_torus torus(4 * (1 + random.below(5)), 2 * (2 + random.below(8)), 1., height,
                           random);
    const Flat_mesh mesh = flat_mesh_of(torus.soup());
    for(int i = 0; i < 25; ++i) {
      const Vertex_walk walk = random_simple_walk(mesh, random);
      const std::pair<int, int> turns = torus.turns(walk);
      if(turns == std::pair(0, 0))
        continue;
      SCOPED_TRACE(testing::Message() << "round " << round << ", loop " << i << ", turns "
                                      << turns.first << ' ' << turns.second);
      const double expected = torus.geodesic_length(turns);
      Crossing_loop once = pushed_left(mesh, walk);
      Loop_tightening(mesh).tighten(once);
      EXPECT_GE(length(mesh, once), (1. - 1e-9) * expected);
      const Crossing_loop geodesic = taut(mesh, once);
      ++all;
      EXPECT_LE(length(mesh, once), 1.01 * expected);
      EXPECT_LE(length(mesh, geodesic), (1. + 1e-3) * expected);
      if(Largest_bend(mesh, geodesic).at_vertices() > tolerance)
        ++bent;
      else
        EXPECT_LE(length(mesh, geodesic), (1. + 1e-9) * expected);
      ++count[turns];
    }
  }
  EXPECT_LE(bent, 0.005 * all) << "of " << all;

  EXPECT_GE(count.size(), 8u) << "classes of loops";
}

TEST(Geodesic, HasNoBendsThatCouldBeTakenOut) {
  Random random(2);
  int bent = 0, all = 0, at_vertices = 0;
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3}, 2)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Crossing_index index(mesh, random_loops(mesh, random, 20));
    for(int i = 0; i < 20; ++i) {
      const Crossing_loop loop = pushed_left(mesh, random_simple_walk(mesh, random));
      if(index.intersections(loop).empty())
        continue; // it may have become a point on the way
      const Crossing_loop geodesic = taut(mesh, loop);
      const Largest_bend bend(mesh, geodesic);
      ++all;
      bent += bend.at_vertices() > tolerance;
      EXPECT_LE(bend.at_edges(), tolerance);
      at_vertices += std::any_of(geodesic.begin(), geodesic.end(),
                                 [](const Crossing& c) { return c.ratio == 0. || c.ratio == 1.; });
    }
  }
  EXPECT_LE(bent, 0.03 * all) << "of " << all;

  EXPECT_GT(at_vertices, 0.2 * all) << "pass a vertex";
}

// A ring of which each cross section is a triangle.
Soup thin_ring(std::size_t number, Random& random) {
  Soup soup;
  for(std::size_t i = 0; i < number; ++i) {
    const double angle = 2. * pi * double(i) / double(number), size = random.uniform(0.3, 1.);
    for(int k = 0; k < 3; ++k) {
      const double around = 2. * pi * (k + random.uniform(0., 0.5)) / 3.,
                   radius = 3. + size * std::cos(around);
      soup.points.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), size * std::sin(around)});
    }
  }
  const auto vertex = [&](std::size_t i, std::size_t k) {
    return static_cast<Index>(3 * (i % number) + k % 3);
  };
  for(std::size_t i = 0; i < number; ++i)
    for(std::size_t k = 0; k < 3; ++k) {
      const Index a = vertex(i, k), b = vertex(i + 1, k), c = vertex(i + 1, k + 1),
                  d = vertex(i, k + 1);
      soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  return soup;
}

// The place where a path is held takes a large part of a loop that crosses few edges.
TEST(Geodesic, HasNoBendsHoweverFewEdgesItCrosses) {
  Random random(4);
  for(int round = 0; round < 30; ++round) {
    const Flat_mesh mesh = flat_mesh_of(thin_ring(4 + random.below(8), random));
    for(Index v = 0; v < mesh.number_of_vertices(); v += 3) {
      SCOPED_TRACE(testing::Message() << "round " << round << ", vertex " << v);
      const Largest_bend bend(mesh, taut(mesh, pushed_left(mesh, {v, v + 1, v + 2})));
      EXPECT_LE(bend.at_edges(), tolerance);
      EXPECT_LE(bend.at_vertices(), tolerance);
    }
  }
}

// Of a pair on a flat torus, one loop is wound around the other, and is unwound: the classes are
// those of a basis of the lattice that is reduced but for a tenth.
TEST(Gauss_reduction, TakesTheTwistOutOfAPair) {
  Random random(3);
  for(int round = 0; round < 40; ++round) {
    const std::size_t columns = 4 * (2 + random.below(4)), rows = 2 * (3 + random.below(5));
    const Flat_torus torus(columns, rows, 1., random.uniform(0.5, 3.), random);
    const Flat_mesh mesh = flat_mesh_of(torus.soup());
    const int twist = static_cast<int>(random.below(9)) - 4;
    Vertex_walk around, twisted;
    for(std::size_t i = 0; i < columns; ++i)
      around.push_back(static_cast<Index>(i));
    for(std::size_t j = 0, i = 0; j < rows; ++j) {
      twisted.push_back(static_cast<Index>(j * columns + i));
      const std::size_t steps =
          static_cast<std::size_t>(std::abs(twist)) * columns * (j + 1) / rows -
          static_cast<std::size_t>(std::abs(twist)) * columns * j / rows;
      for(std::size_t k = 0; k < steps; ++k) {
        i = (twist > 0 ? i + 1 : i + columns - 1) % columns;
        twisted.push_back(static_cast<Index>(j * columns + i));
      }
    }
    SCOPED_TRACE(testing::Message() << "round " << round << ", twist " << twist);
    ASSERT_EQ(torus.turns(around), std::pair(1, 0));
    ASSERT_EQ(torus.turns(twisted), std::pair(twist, 1));
    Crossing_loop a = pushed_left(mesh, around), b = pushed_left(mesh, twisted);
    CGAL::Handle_tunnel_loops::internal::Gauss_reduction({}, mesh).reduce(a, b);
    a = taut(mesh, a);
    b = taut(mesh, b);
    const auto turns = [&torus](const Crossing_loop& loop) {
      Vertex_walk walk;
      for(const Crossing& c : loop)
        walk.push_back(c.left);
      return torus.turns(walk);
    };
    const auto [p, q] = turns(a);
    const auto [r, s] = turns(b);
    EXPECT_EQ(std::abs(p * s - q * r), 1);
    const double shorter = (std::min)(length(mesh, a), length(mesh, b)),
                 longer = (std::max)(length(mesh, a), length(mesh, b));
    for(const int sign : {-1, 1}) {
      const double changed = torus.geodesic_length({p + sign * r, q + sign * s});
      EXPECT_TRUE(longer < 1.15 * shorter || changed > 0.98 * longer)
          << shorter << ' ' << longer << ' ' << changed;
    }
  }
}

} // namespace test_geodesics
