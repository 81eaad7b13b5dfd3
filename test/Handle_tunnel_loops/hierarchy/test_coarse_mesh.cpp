// Coarse meshes of the same topology: that they are meshes, that cells are what they are said to
// be, and that loops keep their classes on the way there and back.

#include "Crossing_loops.h"
#include "Surfaces_for_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace test_coarse_mesh {

using namespace surfaces_for_cells;

// Of vertices that are the mesh itself little is asked: two may have no third neighbour.
void expect_closed_manifold(const Flat_mesh& mesh) {
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    EXPECT_EQ(std::set<Index>(ring.begin(), ring.end()).size(), ring.size());
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      ASSERT_NE(a, v);
      ASSERT_LT(mesh.ring(a).position(b), mesh.ring(a).size());
      ASSERT_EQ(mesh.ring(a).after(b), v);
      ASSERT_EQ(mesh.ring(b).after(v), a);
    }
  }
}

std::size_t number_of_components(const Flat_mesh& mesh) {
  std::vector<char> is_seen(mesh.number_of_vertices(), 0);
  std::size_t number = 0;
  for(Index first = 0; first < is_seen.size(); ++first) {
    number += !is_seen[first];
    std::vector<Index> open(1, first);
    for(std::size_t i = 0; i < open.size(); ++i)
      if(!std::exchange(is_seen[open[i]], 1))
        open.insert(open.end(), mesh.ring(open[i]).begin(), mesh.ring(open[i]).end());
  }
  return number;
}

TEST(Coarse_mesh, IsAMeshOfTheSameTopology) {
  for(const Flat_mesh& mesh : meshes())
    for(const Index spacing : spacings) {
      SCOPED_TRACE(testing::Message() << mesh.number_of_vertices() << " / " << spacing);
      const Coarse_mesh coarse = coarse_mesh_of(mesh, spacing);
      expect_closed_manifold(coarse.mesh);
      const long euler_characteristic =
          long(coarse.mesh.number_of_vertices()) - long(coarse.mesh.neighbor.size() / 6);
      EXPECT_EQ(euler_characteristic, 2 * long(mesh.seeds.size()) - 2 * long(mesh.genus));
      EXPECT_EQ(number_of_components(coarse.mesh), mesh.seeds.size());
      EXPECT_EQ(coarse.mesh.number_of_hubs, mesh.number_of_hubs);
    }
}

// Fine meshes of even triangles lose nearly all that they can.
TEST(Coarse_mesh, HasAFractionOfTheVertices) {
  for(const char* kind : {"torus", "lattice", "gyroid"}) {
    const Surface surface(mesh_of({kind, {60000, kind == std::string("torus") ? 1u : 5u, 0}}));
    const Coarse_mesh coarse = coarse_mesh_of(surface.flat(), 16);
    EXPECT_LE(14 * coarse.mesh.number_of_vertices(), surface.flat().number_of_vertices());
    EXPECT_LE(coarse.stretch, 1.4);
    EXPECT_GE(coarse.stretch, 1.);
  }
}

// One that is not coarse is not made, with little work; it can be asked for again.
TEST(Coarse_mesh, IsMadeWithinLimits) {
  const Surface surface(mesh_of({"plates", {20000, 10, 0}}));
  const Flat_mesh& mesh = surface.flat();
  Coarse_mesh_builder builder(Execution(), mesh, 16, mesh.seeds);
  EXPECT_GE(builder.expected_number_of_vertices(), mesh.number_of_vertices() / 8);
  EXPECT_FALSE(builder.build(mesh.number_of_vertices() / 8));
  const std::size_t all = coarse_mesh_of(mesh, 16).mesh.number_of_vertices();
  EXPECT_GE(all, mesh.number_of_vertices() / 4);
  EXPECT_FALSE(builder.build(all, 0));
  EXPECT_FALSE(builder.build(all - 1));
  const auto coarse = builder.build(all);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->mesh.number_of_vertices(), all);
  EXPECT_EQ(coarse->mesh.genus, mesh.genus);
  expect_closed_manifold(coarse->mesh);
}

// So its lengths are about those of the mesh, and no triangle is folded over another.
TEST(Coarse_mesh, HasItsVerticesInTheMiddleOfCells) {
  const Surface surface(mesh_of({"torus", {60000, 1, 0}}));
  const Flat_mesh& mesh = surface.flat();
  const Coarse_mesh coarse = coarse_mesh_of(mesh, 16);
  std::vector<Vector> sum(coarse.centre.size(), Vector{0., 0., 0.});
  std::vector<double> number(sum.size(), 0.);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    sum[coarse.vertex_of(v)] = sum[coarse.vertex_of(v)] + mesh.points[v];
    number[coarse.vertex_of(v)] += 1.;
  }
  for(std::size_t i = 0; i < sum.size(); ++i) {
    const Vector aside = coarse.mesh.points[i] - 1. / number[i] * sum[i];
    EXPECT_LE(dot(aside, aside), 1e-28);
  }
}

// A cell that is beside all others is not divided again and again.
TEST(Coarse_mesh, HasAFractionOfTheVerticesBesideHubs) {
  const Surface surface(mesh_of({"hubs", {20000, 20, 0}}));
  const Coarse_mesh coarse = coarse_mesh_of(surface.flat(), 16);
  EXPECT_LE(8 * coarse.mesh.number_of_vertices(), surface.flat().number_of_vertices());
}

TEST(Coarse_mesh, IsTheMeshItselfIfEachVertexIsACell) {
  for(const Flat_mesh& mesh : meshes()) {
    const Coarse_mesh coarse = coarse_mesh_of(mesh, 1);
    ASSERT_EQ(coarse.mesh.number_of_vertices(), mesh.number_of_vertices());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v), own = coarse.mesh.ring(v);
      ASSERT_EQ(own.size(), ring.size());
      for(Index p = 0; p < own.size(); ++p)
        EXPECT_EQ(own[own.next(p)], ring.after(own[p]));
    }
  }
}

// A tree of edges leads from each vertex to the centre of its cell, without a hub but that alone in
// its cell, and gates lead from cell to cell.
TEST(Coarse_mesh, KnowsTheWaysBetweenItsCentres) {
  for(const Flat_mesh& mesh : meshes())
    for(const Index spacing : spacings) {
      const Coarse_mesh coarse = coarse_mesh_of(mesh, spacing);
      EXPECT_TRUE(std::is_sorted(coarse.centre.begin(), coarse.centre.end()));
      for(Index v = 0; v < mesh.number_of_vertices(); ++v)
        if(const Index parent = coarse.parent[v]; parent != no_index) {
          EXPECT_LT(mesh.ring(v).position(parent), mesh.ring(v).size());
          EXPECT_FALSE(mesh.is_spoke(v, parent));
          EXPECT_EQ(coarse.vertex_of(v), coarse.vertex_of(parent));
        } else
          EXPECT_EQ(coarse.centre[coarse.vertex_of(v)], v);
      for(Index v = 0; v < coarse.mesh.number_of_vertices(); ++v)
        for(Index i = coarse.mesh.row_begin[v]; i < coarse.mesh.row_begin[v + 1]; ++i) {
          const auto [from, to] = coarse.gate[i];
          EXPECT_LT(mesh.ring(from).position(to), mesh.ring(from).size());
          EXPECT_EQ(coarse.vertex_of(from), v);
          EXPECT_EQ(coarse.vertex_of(to), coarse.mesh.neighbor[i]);
        }
      for(std::size_t i = 0; i < mesh.seeds.size(); ++i)
        EXPECT_EQ(coarse.centre[coarse.mesh.seeds[i]], mesh.seeds[i]);
    }
}

TEST(Coarse_mesh, IsTheSameForAllNumbersOfThreads) {
  for(const Flat_mesh& mesh : meshes()) {
    const Coarse_mesh one = coarse_mesh_of(mesh, 16),
                      many = coarse_mesh_of(mesh, 16, Execution::parallel());
    expect_same(one, many);
  }
}

// ---- loops

std::vector<Crossing_loop> lifted(const Coarse_mesh& coarse, std::vector<Crossing_loop> loops) {
  for(Crossing_loop& loop : loops)
    loop = coarse.lifted(loop);
  return loops;
}

std::vector<Crossing_loop> projected(const Coarse_mesh& coarse, std::vector<Crossing_loop> loops) {
  for(Crossing_loop& loop : loops)
    loop = coarse.projected(loop);
  return loops;
}

Integer_matrix intersections(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops) {
  return intersection_matrix(loops, Crossing_index(mesh, loops), loops.size());
}

TEST(Coarse_mesh, KeepsIntersectionNumbersOfLoops) {
  Random random(1);
  for(const Flat_mesh& mesh : meshes())
    if(mesh.seeds.size() == 1)
      for(const Index spacing : spacings) {
        SCOPED_TRACE(testing::Message() << mesh.number_of_vertices() << " / " << spacing);
        const Coarse_mesh coarse = coarse_mesh_of(mesh, spacing);
        const std::vector<Crossing_loop> loops = random_loops(coarse.mesh, random, 8),
                                         fine = random_loops(mesh, random, 8);
        const std::vector<Crossing_loop> up = lifted(coarse, loops), down = projected(coarse, fine);
        for(const Crossing_loop& loop : up)
          expect_crossing_loop(mesh, loop);
        for(const Crossing_loop& loop : down)
          expect_crossing_loop(coarse.mesh, loop);
        EXPECT_EQ(intersections(mesh, up), intersections(coarse.mesh, loops));
        EXPECT_EQ(intersections(coarse.mesh, down), intersections(mesh, fine));
        // ... also there and back, with those that stayed.
        EXPECT_EQ(intersection_matrix(lifted(coarse, down), Crossing_index(mesh, up), up.size()),
                  intersection_matrix(fine, Crossing_index(mesh, up), up.size()));
      }
}

// A coarse mesh has one of its own.
TEST(Coarse_mesh, KeepsIntersectionNumbersThroughTwoLevels) {
  Random random(3);
  for(const Flat_mesh& mesh : meshes())
    if(mesh.seeds.size() == 1) {
      const Coarse_mesh coarse = coarse_mesh_of(mesh, 4), coarser = coarse_mesh_of(coarse.mesh, 4);
      const std::vector<Crossing_loop> loops = random_loops(coarser.mesh, random, 8),
                                       up = lifted(coarse, lifted(coarser, loops));
      for(const Crossing_loop& loop : up)
        expect_crossing_loop(mesh, loop);
      EXPECT_EQ(intersections(mesh, up), intersections(coarser.mesh, loops));
    }
}

// They are walks on the surface, pushed aside.
TEST(Coarse_mesh, LiftsLoopsThroughNoHub) {
  Random random(2);
  std::size_t number = 0;
  for(const Flat_mesh& mesh : meshes())
    if(mesh.number_of_hubs > 0)
      for(const Index spacing : spacings) {
        const Coarse_mesh coarse = coarse_mesh_of(mesh, spacing);
        for(const Crossing_loop& loop : lifted(coarse, random_loops(coarse.mesh, random, 20)))
          for(const Crossing& c : loop) {
            ++number;
            EXPECT_FALSE(mesh.is_hub(c.right));
          }
      }
  EXPECT_GT(number, 1000u);
}

} // namespace test_coarse_mesh
