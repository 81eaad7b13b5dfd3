// How long the loops are against the shortest bases by loops along edges, which are found slowly.
// The loops that are found cross faces, which makes them shorter than any along edges; so a ratio
// that is not above 1 does not say that the basis is the shortest.

#include "Changed_loops.h"
#include "Flat_torus.h"
#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"
#include "Shortest_basis_oracle.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_short_bases {

// ---- the oracle

// The surface of a layer of unit cubes, which the letters in the rows of a picture are.
Soup surface_of_cubes(const std::vector<std::string>& picture) {
  const auto is_cube = [&](int x, int y, int z) {
    return z == 0 && y >= 0 && y < int(picture.size()) && x >= 0 && x < int(picture[y].size()) &&
           picture[y][x] != ' ';
  };
  Soup soup;
  std::map<std::array<int, 3>, Index> numbers;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = numbers.emplace(p, static_cast<Index>(numbers.size()));
    if(is_new)
      soup.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for(int y = 0; y < int(picture.size()); ++y)
    for(int x = 0; x < int(picture[y].size()); ++x)
      for(int d = 0; d < 3 && is_cube(x, y, 0); ++d)
        for(const int side : {0, 1}) {
          std::array<int, 3> beyond = {x, y, 0};
          beyond[d] += side == 1 ? 1 : -1;
          if(is_cube(beyond[0], beyond[1], beyond[2]))
            continue;
          std::array<int, 3> a = {x, y, 0};
          a[d] += side;
          std::array<int, 3> b = a, c = a, e = a;
          ++b[(d + 1) % 3];
          ++c[(d + 1) % 3];
          ++c[(d + 2) % 3];
          ++e[(d + 2) % 3];
          if(side == 0)
            std::swap(b, e);
          soup.triangles.push_back({vertex(a), vertex(b), vertex(c)});
          soup.triangles.push_back({vertex(a), vertex(c), vertex(e)});
        }
  return soup;
}

const std::vector<std::vector<std::string>> pictures = {
    {"###", "# #", "###"}, {"#####", "# # #", "#####"}, {"#######", "# ### #", "#######"}};

TEST(Homology_coordinates, AreZeroAroundVerticesAndThoseOfABasisUnimodular) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    const Flat_mesh flat = flat_mesh_of(recipe);
    const Homology_coordinates coordinates(flat);
    for(Index v = 0; v < flat.number_of_vertices(); ++v) {
      const auto ring = flat.ring(v);
      EXPECT_TRUE(is_zero(coordinates.of({ring.begin(), ring.end()})));
    }
    Integer_matrix of_loops;
    for(const Walk& walk : walks_beside(mesh, find_loops(mesh))) {
      std::vector<Index> vertices;
      for(const auto h : walk)
        vertices.push_back(source(h, mesh));
      const Class_vector x = coordinates.of(vertices);
      of_loops.emplace_back(x.begin(), x.end());
    }
    EXPECT_EQ(abs(determinant(of_loops)), 1);
  }
}

TEST(Integer_span, IsSaturatedIfTheMinorsHaveNoFactorInCommon) {
  EXPECT_TRUE(is_saturated({{2, 3, 5}}));
  EXPECT_TRUE(is_saturated({{6, 10, 15}}));
  EXPECT_FALSE(is_saturated({{6, 10, 14}}));
  EXPECT_FALSE(is_saturated({{0, 0, 0}}));
  EXPECT_TRUE(is_saturated({{1, 2}, {1, 1}}));
  EXPECT_FALSE(is_saturated({{1, 1}, {1, -1}}));
  EXPECT_TRUE(is_saturated({{1, 1, 0}, {1, -1, 1}}));
  EXPECT_FALSE(is_saturated({{1, 1, 0}, {2, 2, 0}}));
}

// Edges run along both shortest closed geodesics of the torus.
TEST(Shortest_basis, OfAFlatTorusIsKnown) {
  generators::Random random(1);
  for(int round = 0; round < 20; ++round) {
    const double height = random.uniform(0.3, 3.);
    const Flat_torus torus(4 * (1 + random.below(3)), 2 * (2 + random.below(4)), 1., height,
                           random);
    const Flat_mesh mesh = flat_mesh_of(torus.soup());
    const Class_lengths basis = Shortest_basis_oracle(mesh).shortest_basis();
    ASSERT_EQ(basis.size(), 2u);
    EXPECT_TRUE(is_saturated(matrix_of(basis)));
    EXPECT_NEAR(basis[0].length, (std::min)(1., height), 1e-9);
    EXPECT_NEAR(basis[1].length, (std::max)(1., height), 1e-9);
  }
}

TEST(Shortest_basis, IsABasisNoLongerThanThatOfOneTree) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Shortest_basis_oracle oracle(mesh);
    const Class_lengths basis = oracle.shortest_basis();
    EXPECT_EQ(basis.size(), oracle.rank());
    EXPECT_TRUE(is_saturated(matrix_of(basis)));
    EXPECT_EQ(abs(determinant(matrix_of(basis))), 1);
    for(Index root = 0; root < mesh.number_of_vertices(); root += 50) {
      const Class_lengths other = oracle.basis_of_tree(root);
      EXPECT_EQ(other.size(), oracle.rank());
      EXPECT_LE(total_length(basis), (1. + 1e-12) * total_length(other));
    }
  }
}

// ---- the loops that are found

// A mesh with its loops, and the classes that bound on either side.
class Measured_loops
{
public:
  explicit Measured_loops(const Soup& soup)
      : mesh_(mesh_of(soup))
      , flat_(flat_mesh_of(soup))
      , oracle_(flat_) {
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh_);
    solver.find_loops(std::back_inserter(pairs_));
    linking_ = solver.certificate().linking;
  }

  const Shortest_basis_oracle& oracle() const { return oracle_; }
  std::size_t genus() const { return pairs_.size(); }

  double length() const { return total_length(pairs_); }

  // Whether the linking numbers mean something.
  bool has_sides() const {
    return !linking_.empty() && std::all_of(linking_.begin(), linking_.end(),
                                            [](const auto& l) { return l.problem.empty(); });
  }
  bool is_pure() const {
    for(std::size_t i = 0; i < linking_.size(); ++i)
      if(!(i % 2 == 0 ? linking_[i].bounds_inside() : linking_[i].bounds_outside()))
        return false;
    return true;
  }

  // A class with coordinates a in the basis of the loops bounds inside if a V = 0, outside if
  // V a = 0; and x = a B, where the rows of B are the classes of the loops.
  Kernel_of_matrix inside() const {
    return Kernel_of_matrix(product(unimodular_inverse(classes_of_loops()), linking_matrix()));
  }
  Kernel_of_matrix outside() const {
    return Kernel_of_matrix(
        product(unimodular_inverse(classes_of_loops()), transposed(linking_matrix())));
  }

private:
  Integer_matrix linking_matrix() const {
    Integer_matrix matrix(linking_.size(), std::vector<Integer>(linking_.size(), 0));
    for(std::size_t i = 0; i < linking_.size(); ++i)
      for(const auto& [j, number] : linking_[i].row)
        matrix[i][j] = number;
    return matrix;
  }

  Integer_matrix classes_of_loops() const {
    Integer_matrix matrix;
    for(const Walk& walk : walks_beside(mesh_, pairs_)) {
      std::vector<Index> vertices;
      for(const auto h : walk)
        vertices.push_back(source(h, mesh_));
      const Class_vector x = oracle_.coordinates().of(vertices);
      matrix.emplace_back(x.begin(), x.end());
    }
    return matrix;
  }

  Mesh mesh_;
  Flat_mesh flat_;
  Shortest_basis_oracle oracle_;
  Pairs pairs_;
  std::vector<CGAL::Handle_tunnel_loops::Loop_linking> linking_;
};

// Around each bar, and around each hole.
TEST(Sides, OfCubesWithHolesHaveKnownBases) {
  for(const auto& [picture, inside, outside] :
      {std::tuple(pictures[0], 4., 4.), std::tuple(pictures[1], 8., 8.),
       std::tuple(pictures[2], 8., 8.)})
  {
    const Measured_loops loops(surface_of_cubes(picture));
    ASSERT_TRUE(loops.has_sides());
    const Shortest_basis_oracle& oracle = loops.oracle();
    for(const auto& [kernel, expected] :
        {std::pair(loops.inside(), inside), std::pair(loops.outside(), outside)})
    {
      const Class_lengths found = oracle.best_found(kernel);
      EXPECT_EQ(found.size(), loops.genus());
      EXPECT_TRUE(is_saturated(matrix_of(found)));
      EXPECT_NEAR(total_length(found), expected, 1e-9);
      EXPECT_NEAR(total_length(oracle.optimum(kernel, found)), expected, 1e-9);
    }
    EXPECT_NEAR(total_length(oracle.shortest_basis()), inside + outside, 1e-9);
  }
}

// All classes are a kernel as well.
TEST(Sides, HaveAnOptimumThatIsThatOfTheGreedy) {
  generators::Random random(2);
  for(int round = 0; round < 10; ++round) {
    const Flat_torus torus(8, 4, 1., random.uniform(0.5, 2.), random);
    const Flat_mesh mesh = flat_mesh_of(torus.soup());
    const Shortest_basis_oracle oracle(mesh);
    const Kernel_of_matrix all(Integer_matrix(2, std::vector<Integer>(2, 0)));
    const Class_lengths shortest = oracle.shortest_basis(), other = oracle.basis_of_tree(13);
    const double length = total_length(shortest);
    EXPECT_NEAR(total_length(oracle.optimum(all, shortest)), length, 1e-9 * length);
    EXPECT_NEAR(total_length(oracle.optimum(all, other)), length, 1e-9 * length);
    EXPECT_NEAR(total_length(oracle.best_found(all)), length, 1e-9 * length);
  }
}

// What is best found on a side is hardly longer than the optimum.
TEST(Sides, HaveGoodBasesThatAreFound) {
  for(const Recipe& recipe : {Recipe{"torus", {200, 1, 0}}, Recipe{"knot", {400, 1, 0}},
                              Recipe{"multi-torus", {400, 1, 0}},
                              Recipe{"multi-torus", {800, 2, 0}}, Recipe{"sponge", {400, 1, 0}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Measured_loops loops(soup_of(recipe));
    ASSERT_TRUE(loops.has_sides());
    for(const Kernel_of_matrix& kernel : {loops.inside(), loops.outside()}) {
      const Class_lengths found = loops.oracle().best_found(kernel);
      ASSERT_EQ(found.size(), loops.genus());
      const double optimum = total_length(loops.oracle().optimum(kernel, found));
      std::cout << testing::PrintToString(recipe) << ": best found over optimum "
                << total_length(found) / optimum << std::endl;
      EXPECT_GE(total_length(found), (1. - 1e-9) * optimum);
      EXPECT_LE(total_length(found), 1.05 * optimum);
    }
  }
}

// ---- how long the loops are

// The largest ratios of the total length of the loops to that of the shortest basis, and to that of
// the best bases that are found of the classes that bound inside and outside. What is aimed at is
// 1.02. Random surfaces cross themselves.
constexpr double largest_ratio = 1.2, largest_ratio_by_sides = 1.005, largest_ratio_at_random = 4.3;

// The ratio to what is best on both sides, or 0 if the search there finds no bases.
double ratio_by_sides(const Measured_loops& loops) {
  double sum = 0.;
  for(const Kernel_of_matrix& kernel : {loops.inside(), loops.outside()}) {
    const Class_lengths found = loops.oracle().best_found(kernel);
    if(found.size() < loops.genus() || !is_saturated(matrix_of(found)))
      return 0.;
    sum += total_length(found);
  }
  return loops.length() / sum;
}

// Prints the ratios.
void expect_short(const std::string& name, const Soup& soup, double bound = largest_ratio) {
  const Measured_loops loops(soup);
  const Class_lengths shortest = loops.oracle().shortest_basis();
  EXPECT_TRUE(is_saturated(matrix_of(shortest)));
  const double ratio = loops.length() / total_length(shortest),
               by_sides = loops.has_sides() ? ratio_by_sides(loops) : 0.;
  std::cout << name << ": genus " << loops.genus() << ", length over the shortest basis " << ratio;
  if(by_sides > 0.)
    std::cout << ", over the best found of those that bound " << by_sides;
  std::cout << (loops.is_pure() ? "" : ", not all of them bound") << std::endl;
  EXPECT_LE(ratio, bound) << name;
  EXPECT_LE(by_sides, largest_ratio_by_sides) << name;
  // The classes that bound on either side are a basis together.
  EXPECT_LE(by_sides, (1. + 1e-9) * ratio);
}

TEST(Lengths, AreThoseOfShortBasesOnGeneratedSurfaces) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2, 3}, 2))
    expect_short(testing::PrintToString(recipe), soup_of(recipe),
                 recipe.kind == "random" ? largest_ratio_at_random : largest_ratio);
}

bool is_connected(const Soup& soup) {
  std::vector<std::vector<Index>> neighbors(soup.points.size());
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      neighbors[t[i]].push_back(t[(i + 1) % 3]);
  std::vector<char> is_reached(soup.points.size(), 0);
  std::vector<Index> queue(1, 0);
  is_reached[0] = 1;
  for(std::size_t q = 0; q < queue.size(); ++q)
    for(const Index v : neighbors[queue[q]])
      if(!is_reached[v]) {
        is_reached[v] = 1;
        queue.push_back(v);
      }
  return queue.size() == soup.points.size();
}

Soup soup_of_mesh(const Mesh& mesh) {
  Soup soup;
  for(const auto v : mesh.vertices())
    soup.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for(const auto f : mesh.faces()) {
    std::vector<Index> corners;
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(v);
    soup.triangles.push_back({corners[0], corners[1], corners[2]});
  }
  return soup;
}

TEST(Lengths, AreThoseOfShortBasesOnMeshesOfFiles) {
  constexpr std::uintmax_t largest_file = 200000;
  constexpr std::size_t most_faces = 2000;
  if(files_of_corpus().empty())
    GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
  for(const std::filesystem::path& file : files_of_corpus()) {
    Mesh mesh;
    if(file.parent_path().filename() != "closed" || file_size(file) > largest_file ||
       !CGAL::IO::read_polygon_mesh(file.string(), mesh) || mesh.number_of_faces() > most_faces)
      continue;
    const Soup soup = soup_of_mesh(mesh);
    if(is_connected(soup))
      expect_short(file.stem().string(), soup);
  }
}

} // namespace test_short_bases
