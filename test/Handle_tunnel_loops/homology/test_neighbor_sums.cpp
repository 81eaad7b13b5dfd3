// Of a loop that winds around another one, the sum without the winding is found, and is as short as
// the geodesic of its class; a loop that does not wind has no shorter sum.

#include "Crossing_loops.h"
#include "Flat_torus.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Neighbor_sums.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_neighbor_sums {

using namespace CGAL::Handle_tunnel_loops::internal;

constexpr std::size_t columns = 16, rows = 12;

Crossing_loop taut(const Flat_mesh& mesh, const Vertex_walk& walk) {
  Crossing_loop loop = pushed_left(mesh, walk);
  Loop_tightening(mesh).tighten(loop);
  return loop;
}

// Along a row, and across all rows with so many turns along them.
std::vector<Crossing_loop> loops_with_turns(const Flat_mesh& mesh, std::size_t turns) {
  Vertex_walk along, across;
  for(std::size_t i = 0; i < columns; ++i)
    along.push_back(static_cast<Index>(i));
  for(std::size_t j = 0, i = 0; j < rows; ++j) {
    across.push_back(static_cast<Index>(j * columns + i % columns));
    for(const std::size_t end = turns * columns * (j + 1) / rows; i < end;)
      across.push_back(static_cast<Index>(j * columns + ++i % columns));
  }
  return {taut(mesh, along), taut(mesh, across)};
}

std::vector<Crossing_loop> sums_of_second(const Flat_mesh& mesh,
                                          const std::vector<Crossing_loop>& loops,
                                          bool is_wanted,
                                          double work = 1e6) {
  const Crossing_index index(mesh, loops);
  const std::vector<double> lengths = {length(mesh, loops[0]), length(mesh, loops[1])};
  return Neighbor_sums({}, mesh, loops, index, lengths).of(1, work, [=](Index) {
    return is_wanted;
  });
}

TEST(Neighbor_sums, TakeOutATurn) {
  Random random(1);
  const Flat_torus torus(columns, rows, 1., 1.5, random);
  const Flat_mesh mesh = flat_mesh_of(torus.soup());
  const std::vector<Crossing_loop> straight = loops_with_turns(mesh, 0),
                                   wound = loops_with_turns(mesh, 1);
  ASSERT_GT(length(mesh, wound[1]), 1.1 * length(mesh, straight[1]));
  const std::vector<Crossing_loop> sums = sums_of_second(mesh, wound, true);
  ASSERT_EQ(sums.size(), 1);
  EXPECT_NEAR(length(mesh, sums[0]) / length(mesh, straight[1]), 1., 1e-3);
  EXPECT_TRUE(sums_of_second(mesh, wound, false).empty());
  EXPECT_TRUE(sums_of_second(mesh, wound, true, 0.).empty());
  EXPECT_TRUE(sums_of_second(mesh, straight, true).empty());
}

// Each loop has the same share for each of its crossings.
TEST(Neighbor_sums, ShareTheirWorkBySize) {
  Random random(2);
  for(int run = 0; run < 20; ++run) {
    std::vector<Crossing_loop> loops(1 + run);
    double size = 0.;
    for(Crossing_loop& loop : loops) {
      loop.resize(static_cast<std::size_t>(random.uniform(1., 1000.)));
      size += double(loop.size());
    }
    const double work = random.uniform(0., 1e8);
    const std::vector<double> shares = shares_by_size(loops, work);
    ASSERT_EQ(shares.size(), loops.size());
    for(std::size_t i = 0; i < loops.size(); ++i)
      EXPECT_NEAR(shares[i] * size, work * double(loops[i].size()), 1e-9 * work * size);
  }
}

// With more work all is found that was found with less, and nothing with too little for a sum.
TEST(Neighbor_sums, EndWithTheirWork) {
  Random random(1);
  const Flat_torus torus(columns, rows, 1., 1.5, random);
  const Flat_mesh mesh = flat_mesh_of(torus.soup());
  const std::vector<Crossing_loop> wound = loops_with_turns(mesh, 1);
  std::size_t before = 0, number_of_steps = 0;
  for(double work = 1.; work < 1e5; work *= 2.) {
    const std::size_t number = sums_of_second(mesh, wound, true, work).size();
    EXPECT_GE(number, before) << work;
    EXPECT_TRUE(number == 0 || work >= double(wound[1].size()));
    number_of_steps += number > before;
    before = number;
  }
  EXPECT_EQ(before, 1u);
  EXPECT_EQ(number_of_steps, 1u);
}

} // namespace test_neighbor_sums
