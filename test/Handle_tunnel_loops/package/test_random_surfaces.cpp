// Thousands of random surfaces, most of them ugly: the number of pairs is the genus, and the
// certificate, without which nothing is returned, holds.

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_random_surfaces {

using CGAL::Handle_tunnel_loops::internal::Index;
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
  for(int i = 0; i < number_of_cases(3000); ++i)
    expect_as_many_pairs_as_handles(random_recipe(random, 20, 3000));
}

TEST(Large_random_surfaces, HaveAsManyPairsAsHandles) {
  Random random(5);
  for(int i = 0; i < number_of_cases(60); ++i)
    expect_as_many_pairs_as_handles(random_recipe(random, 3000, 20000));
}

TEST(Random_surfaces, HaveLoopsAsDefined) {
  Random random(2);
  for(int i = 0; i < number_of_cases(300); ++i) {
    const Recipe recipe = random_recipe(random, 20, 500);
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    expect_handle_tunnel_pairs(mesh, find_loops(mesh), recipe.request.genus);
  }
}

TEST(Random_surfaces, CanBeSweptFromEveryVertex) {
  Random random(3);
  for(int i = 0; i < number_of_cases(60); ++i) {
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
  for(int i = 0; i < number_of_cases(100); ++i) {
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

// ---- vertices with many edges

// A washer whose hole has three corners, each with a third of the edges of either side.
Soup washer(Index corners) {
  Soup soup;
  const auto ring = [&](Index number, double radius, double height) {
    const Index first = static_cast<Index>(soup.points.size());
    for(Index i = 0; i < number; ++i) {
      const double angle = 2. * 3.14159265358979323846 * i / number;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
    return first;
  };
  const Index upper = ring(corners, 3., 0.5), upper_hole = ring(3, 1., 0.5),
              lower = ring(corners, 3., 0.), lower_hole = ring(3, 1., 0.);
  const auto add = [&](Index a, Index b, Index c) { soup.triangles.push_back({a, b, c}); };
  for(Index k = 0; k < corners; ++k) {
    const Index l = (k + 1) % corners, c = 3 * k / corners, d = 3 * l / corners;
    add(upper + k, upper + l, upper_hole + c);
    add(lower + l, lower + k, lower_hole + c);
    add(lower + k, lower + l, upper + l);
    add(lower + k, upper + l, upper + k);
    if(c == d)
      continue;
    add(upper_hole + c, upper + l, upper_hole + d);
    add(lower_hole + d, lower + l, lower_hole + c);
    add(lower_hole + d, lower_hole + c, upper_hole + c);
    add(lower_hole + d, upper_hole + c, upper_hole + d);
  }
  return soup;
}

// It would take hours if the time grew with the square of the number of edges, many times over.
TEST(Vertices_with_many_edges, AreLikeOthers) {
  for(const Index corners : {300, 24000}) {
    const Mesh mesh = mesh_of(washer(corners));
    const Pairs pairs = find_loops(mesh);
    expect_handle_tunnel_pairs(mesh, pairs, 1);
    EXPECT_NEAR(total_length(pairs), 5. + 3. * std::sqrt(3.), 0.01);
  }
}

} // namespace test_random_surfaces
