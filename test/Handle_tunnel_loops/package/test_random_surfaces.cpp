// Thousands of random surfaces, most of them ugly: the number of pairs is the genus, and the
// certificate, without which nothing is returned, holds.

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using generators::Random;

// As many small ones as large ones.
std::size_t random_number(Random& random, std::size_t low, std::size_t high) {
  return static_cast<std::size_t>(
      std::exp(random.uniform(std::log(static_cast<double>(low)), std::log(high + 1.))));
}

Recipe random_recipe(Random& random, std::size_t least_faces, std::size_t most_faces) {
  const std::size_t faces = random_number(random, least_faces, most_faces);
  const std::size_t largest_genus = (std::min)(std::size_t(100), (faces - 2) / 12);
  const std::size_t genus = random_number(random, 1, largest_genus + 1) - 1;
  return {"random", {faces, genus, static_cast<unsigned>(random.next())}};
}

void expect_as_many_pairs_as_handles(const Recipe& recipe) {
  SCOPED_TRACE(testing::PrintToString(recipe));
  const Mesh mesh = mesh_of(recipe);
  ASSERT_NO_THROW(EXPECT_EQ(find_loops(mesh).size(), recipe.request.genus));
}

TEST(Random_surfaces, HaveAsManyPairsAsHandles) {
  Random random(1);
  for(int i = 0; i < 3000; ++i)
    expect_as_many_pairs_as_handles(random_recipe(random, 20, 3000));
}

TEST(Large_random_surfaces, HaveAsManyPairsAsHandles) {
  Random random(5);
  for(int i = 0; i < 60; ++i)
    expect_as_many_pairs_as_handles(random_recipe(random, 3000, 20000));
}

TEST(Random_surfaces, HaveLoopsAsDefined) {
  Random random(2);
  for(int i = 0; i < 300; ++i) {
    const Recipe recipe = random_recipe(random, 20, 500);
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    expect_handle_tunnel_pairs(mesh, find_loops(mesh), recipe.request.genus);
  }
}

TEST(Random_surfaces, CanBeSweptFromEveryVertex) {
  Random random(3);
  for(int i = 0; i < 60; ++i) {
    const Recipe recipe = random_recipe(random, 20, 200);
    const Mesh mesh = mesh_of(recipe);
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    for(const Mesh::Vertex_index v : vertices(mesh)) {
      SCOPED_TRACE(testing::Message() << recipe << ", seed vertex " << v);
      Pairs pairs;
      ASSERT_NO_THROW(
          solver.find_loops(std::back_inserter(pairs), CGAL::parameters::seed_vertex(v)));
      EXPECT_EQ(pairs.size(), recipe.request.genus);
    }
  }
}

// Components of all kinds of shapes in one mesh, numbered at random.
TEST(Random_surfaces, MayHaveManyComponents) {
  Random random(4);
  for(int i = 0; i < 100; ++i) {
    std::vector<Soup> soups;
    std::size_t genus = 0;
    const std::size_t number_of_components = 2 + random.below(6);
    for(std::size_t c = 0; c < number_of_components; ++c) {
      const Recipe recipe = random_recipe(random, 20, 300);
      soups.push_back(soup_of(recipe));
      genus += recipe.request.genus;
    }
    SCOPED_TRACE(testing::Message() << "mesh " << i << " of " << number_of_components);
    const unsigned seed = static_cast<unsigned>(i);
    const Mesh mesh =
        mesh_of(generators::permute_vertices(generators::disjoint_union(soups), seed));
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    EXPECT_EQ(solver.number_of_components(), number_of_components);
    EXPECT_EQ(solver.genus(), genus);
    Pairs pairs;
    ASSERT_NO_THROW(solver.find_loops(std::back_inserter(pairs)));
    EXPECT_EQ(pairs.size(), genus);
  }
}

} // namespace
