// Handle and tunnel loops are what their definitions say, on small meshes of all kinds.

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace test_loop_definitions {

constexpr double pi = 3.14159265358979;

class Loops_of_mesh : public testing::TestWithParam<Recipe>
{};

std::string name_of_recipe(const testing::TestParamInfo<Recipe>& info) {
  std::string name = info.param.kind + "_g" + std::to_string(info.param.request.genus) + "_s" +
                     std::to_string(info.param.request.seed);
  for(char& c : name)
    c = c == '-' ? '_' : c;
  return name;
}

TEST_P(Loops_of_mesh, AreAPairedBasisFromEverySeed) {
  const Recipe& recipe = GetParam();
  const Mesh mesh = mesh_of(recipe);
  const std::size_t n = num_vertices(mesh);
  for(const std::size_t seed : {std::size_t(0), n / 3, n - 1}) {
    SCOPED_TRACE(testing::Message() << recipe << ", seed vertex " << seed);
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(seed));
    expect_handle_tunnel_pairs(mesh, find_loops(mesh, CGAL::parameters::seed_vertex(v)),
                               recipe.request.genus);
  }
}

INSTANTIATE_TEST_SUITE_P(All_kinds,
                         Loops_of_mesh,
                         testing::ValuesIn(recipes_of_all_kinds({0, 1, 2, 3, 5, 12}, 2)),
                         name_of_recipe);

INSTANTIATE_TEST_SUITE_P(Parts_and_tubes,
                         Loops_of_mesh,
                         testing::Values(Recipe{"plates", {200, 7, 0}},
                                         Recipe{"plates", {3000, 12, 1, 4}},
                                         Recipe{"bars", {200, 7, 0}},
                                         Recipe{"bars", {3000, 12, 1, 4}},
                                         Recipe{"chain", {1500, 5, 0}},
                                         Recipe{"torus-link", {5000, 3, 0}},
                                         Recipe{"ladder", {30000, 6, 0}},
                                         Recipe{"shell", {5000, 4, 3}},
                                         Recipe{"foam", {5000, 5, 0}},
                                         Recipe{"interlaced", {5000, 6, 0}}),
                         name_of_recipe);

INSTANTIATE_TEST_SUITE_P(Smallest,
                         Loops_of_mesh,
                         testing::Values(Recipe{"sphere", {4, 0, 0}},
                                         Recipe{"torus", {18, 1, 0}},
                                         Recipe{"random", {14, 1, 0}},
                                         Recipe{"random", {26, 2, 1}},
                                         Recipe{"random", {38, 3, 2}},
                                         Recipe{"random", {122, 10, 3}}),
                         name_of_recipe);

INSTANTIATE_TEST_SUITE_P(High_genus,
                         Loops_of_mesh,
                         testing::Values(Recipe{"lattice", {20000, 60, 0}},
                                         Recipe{"sponge", {9000, 60, 0}},
                                         Recipe{"random", {3000, 60, 0}}),
                         name_of_recipe);

TEST(Loops_of_several_components, AreThoseOfAllOfThem) {
  const std::vector<Recipe> parts = {{"random", {200, 5, 4}},       {"sphere", {100, 0, 0}},
                                     {"multi-torus", {1500, 3, 0}}, {"torus", {300, 1, 0}},
                                     {"random", {14, 1, 5}},        {"sphere", {4, 0, 0}}};
  std::vector<Soup> soups;
  for(const Recipe& part : parts)
    soups.push_back(soup_of(part));
  const Soup all = generators::disjoint_union(soups);
  for(unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(testing::Message() << "permutation " << seed);
    const Mesh mesh = mesh_of(generators::permute_vertices(all, seed));
    expect_handle_tunnel_pairs(mesh, find_loops(mesh), 10);
  }
}

std::vector<Mesh::Vertex_index> eight_vertices(const Mesh& mesh) {
  std::vector<Mesh::Vertex_index> vertices;
  for(Mesh::size_type i = 0; i < 8; ++i)
    vertices.emplace_back(i * mesh.number_of_vertices() / 8);
  return vertices;
}

// On a torus of revolution with radii 1 and 0.4 the shortest handle loop is a circle around the
// tube, the shortest tunnel loop the inner equator.
class Loops_of_torus : public testing::TestWithParam<std::tuple<bool, std::size_t>>
{};

TEST_P(Loops_of_torus, AreItsCircles) {
  const auto [looks_inwards, faces] = GetParam();
  Soup soup = soup_of({"torus", {faces, 1, 0}});
  if(looks_inwards)
    reverse_orientation(soup);
  const Mesh mesh = mesh_of(soup);
  for(const Mesh::Vertex_index seed : eight_vertices(mesh)) {
    SCOPED_TRACE(testing::Message() << "seed vertex " << seed);
    const Pairs pairs = find_loops(mesh, CGAL::parameters::seed_vertex(seed));
    expect_handle_tunnel_pairs(mesh, pairs, 1);
    EXPECT_NEAR(pairs[0].handle().length(), 2. * pi * 0.4, 0.02 * 2. * pi * 0.4);
    EXPECT_NEAR(pairs[0].tunnel().length(), 2. * pi * 0.6, 0.02 * 2. * pi * 0.6);
    for(const auto& p : pairs[0].tunnel().points())
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 0.6, 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(Of_all_sizes,
                         Loops_of_torus,
                         testing::Combine(testing::Bool(), testing::Values(4000, 200000)),
                         [](const auto& test) {
                           return std::to_string(std::get<1>(test.param)) +
                                  (std::get<0>(test.param) ? "_inwards" : "_outwards");
                         });

// A tube much longer than it is thick: what goes around it is short, and bounds in the solid.
TEST(Loops_of_knot, AreAroundTheTubeAndAlongIt) {
  for(const std::size_t faces : {3000, 20000}) {
    const Mesh mesh = mesh_of({"knot", {faces, 1, 0}});
    for(const Mesh::Vertex_index seed : eight_vertices(mesh)) {
      SCOPED_TRACE(testing::Message() << faces << " faces, seed vertex " << seed);
      const Pairs pairs = find_loops(mesh, CGAL::parameters::seed_vertex(seed));
      expect_handle_tunnel_pairs(mesh, pairs, 1);
      EXPECT_LT(pairs[0].handle().length(), 0.2 * pairs[0].tunnel().length());
    }
  }
}

TEST(Loops_of_slab, GoAroundAndThroughItsHoles) {
  // Unit distances between holes of the same size: all handles are alike, and so are the tunnels.
  const Mesh mesh = mesh_of({"multi-torus", {12000, 4, 0}});
  const Pairs pairs = find_loops(mesh);
  expect_handle_tunnel_pairs(mesh, pairs, 4);
  for(const auto& pair : pairs)
    for(const auto& other : pairs) {
      EXPECT_LT(pair.handle().length(), 1.3 * other.handle().length());
      EXPECT_LT(pair.tunnel().length(), 1.3 * other.tunnel().length());
    }
}

} // namespace test_loop_definitions
