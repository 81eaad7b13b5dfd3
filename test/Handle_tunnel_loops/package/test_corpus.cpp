// All closed meshes of the corpus: the number of pairs is the genus by Euler's formula, and the
// certificate, without which nothing is returned, holds.

#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace test_corpus {

using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

// Where there is a folder, the tests below are about something.
TEST(Corpus, HasClosedMeshes) {
  if(!std::filesystem::is_directory(mesh_corpus()))
    GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
  const std::vector<std::filesystem::path> files = files_of_corpus();
  for(const char* folder : {"closed", "sphere_like"})
    EXPECT_TRUE(std::any_of(files.begin(), files.end(), [folder](const auto& file) {
      return file.parent_path().filename() == folder;
    })) << folder;
}

class Mesh_of_corpus : public testing::TestWithParam<std::filesystem::path>
{};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Mesh_of_corpus);
INSTANTIATE_TEST_SUITE_P(Files, Mesh_of_corpus, testing::ValuesIn(files_of_corpus()), name_of_file);

std::size_t number_of_components(const Mesh& mesh) {
  std::vector<char> is_visited(mesh.number_of_vertices(), 0);
  std::size_t count = 0;
  for(const Mesh::Vertex_index first : mesh.vertices()) {
    if(is_visited[first] || mesh.is_isolated(first))
      continue;
    ++count;
    std::vector<Mesh::Vertex_index> stack(1, first);
    while(!stack.empty()) {
      const Mesh::Vertex_index v = stack.back();
      stack.pop_back();
      if(std::exchange(is_visited[v], 1))
        continue;
      for(const Mesh::Vertex_index u : CGAL::vertices_around_target(v, mesh))
        stack.push_back(u);
    }
  }
  return count;
}

std::size_t genus_of(const Mesh& mesh) {
  const auto vertices = mesh.vertices();
  const auto number_of_vertices =
      std::count_if(vertices.begin(), vertices.end(),
                    [&mesh](Mesh::Vertex_index v) { return !mesh.is_isolated(v); });
  const std::ptrdiff_t euler_characteristic = number_of_vertices -
                                              static_cast<std::ptrdiff_t>(mesh.number_of_edges()) +
                                              static_cast<std::ptrdiff_t>(mesh.number_of_faces());
  return number_of_components(mesh) - static_cast<std::size_t>(euler_characteristic / 2);
}

TEST_P(Mesh_of_corpus, HasAsManyPairsAsHandles) {
  Mesh mesh;
  ASSERT_TRUE(CGAL::IO::read_polygon_mesh(GetParam().string(), mesh));
  const std::size_t genus = genus_of(mesh);
  const bool is_sphere_like = GetParam().parent_path().filename() == "sphere_like";
  EXPECT_EQ(genus == 0, is_sphere_like);
  Solver solver(mesh);
  EXPECT_EQ(solver.genus(), genus);
  std::vector<std::size_t> seeds = {0};
  if(mesh.number_of_faces() < 20000)
    seeds = {0, mesh.number_of_vertices() / 2, mesh.number_of_vertices() - 1};
  for(const std::size_t seed : seeds) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(seed));
    if(mesh.is_isolated(v))
      continue;
    SCOPED_TRACE(testing::Message() << GetParam() << ", seed vertex " << v);
    Pairs pairs;
    ASSERT_NO_THROW(solver.find_loops<CGAL::Parallel_if_available_tag>(
        std::back_inserter(pairs), CGAL::parameters::seed_vertex(v)));
    EXPECT_EQ(pairs.size(), genus);
  }
}

} // namespace test_corpus
