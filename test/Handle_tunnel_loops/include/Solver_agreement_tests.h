#ifndef HTL_TEST_SOLVER_AGREEMENT_TESTS_H
#define HTL_TEST_SOLVER_AGREEMENT_TESTS_H

#include "Flat_mesh_of_soup.h"
#include "Mesh_corpus.h"
#include "Number_of_cases.h"
#include "Solver_agreement.h"
#include "with.h"

#include "generators/Random.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <vector>

// The tests that every solver has to pass, against another one and against the definitions.

// A solver and the one that it is compared with, by their tags, and what the tests are made in.
template <typename TestedTag,
          typename ExpectedTag = CGAL::Sequential_tag,
          typename TestFixture = testing::Test>
struct Comparison
{
  using Tested = TestedTag;
  using Expected = ExpectedTag;
  using Fixture = TestFixture;
};

template <typename Comparison> class Solver : public Comparison::Fixture
{};

TYPED_TEST_SUITE_P(Solver);

// All but those that are random.
TYPED_TEST_P(Solver, AgreesOnGeneratedSurfaces) {
  Compared compared;
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2, 7}, 2)) {
    SCOPED_TRACE(recipe);
    expect_agreement<typename TypeParam::Tested, typename TypeParam::Expected>(
        mesh_of(recipe), recipe.request.genus, &compared);
  }
  compared.expect_classes(0.7);
}

// Far coarser than the front is wide. They cross themselves, so that hardly a loop bounds on a
// side, and classes are not compared.
TYPED_TEST_P(Solver, AgreesOnTheCoarsestSurfaces) {
  expect_agreement<typename TypeParam::Tested, typename TypeParam::Expected>(
      mesh_of(smallest_torus()), 1);
  generators::Random random(21);
  for(int i = 0; i < number_of_cases(100); ++i) {
    const std::size_t genus = random.below(9);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(100), genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(recipe);
    expect_agreement<typename TypeParam::Tested, typename TypeParam::Expected>(mesh_of(recipe),
                                                                               genus);
  }
}

TYPED_TEST_P(Solver, TreatsAllComponents) {
  const Soup soup =
      generators::disjoint_union({soup_of({"torus", {800, 1, 0}}), soup_of({"sphere", {200, 0, 0}}),
                                  soup_of({"multi-torus", {1500, 3, 0}}), smallest_torus()});
  expect_agreement<typename TypeParam::Tested, typename TypeParam::Expected>(mesh_of(soup), 5);
  expect_agreement<typename TypeParam::Tested, typename TypeParam::Expected>(
      mesh_of(generators::permute_vertices(soup, 3)), 5);
}

TYPED_TEST_P(Solver, KnowsInsideFromOutside) {
  Soup soup = soup_of({"multi-torus", {2000, 2, 0}});
  expect_same_classes<typename TypeParam::Tested, typename TypeParam::Expected>(mesh_of(soup));
  reverse_orientation(soup);
  expect_same_classes<typename TypeParam::Tested, typename TypeParam::Expected>(mesh_of(soup));
}

// Where handles lie beside each other in a thin wall, as in a sponge, a loop that is a streamline
// may bound on neither side; there it is enough that both answers are certified.
TYPED_TEST_P(Solver, FindsLoopsOfTheSameClasses) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2, 7}, 2))
    if(recipe.kind != "random" && recipe.kind != "sponge") {
      SCOPED_TRACE(recipe);
      expect_same_classes<typename TypeParam::Tested, typename TypeParam::Expected>(
          mesh_of(recipe));
    }
}

// Streamlines are longer than what was tightened, but of the same kind.
TYPED_TEST_P(Solver, FindsLoopsOfSimilarLengths) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2, 7}, 1))
    if(recipe.kind != "random") {
      SCOPED_TRACE(recipe);
      expect_similar_lengths<typename TypeParam::Tested, typename TypeParam::Expected>(
          mesh_of(recipe), 0.95, 1.2);
    }
}

TYPED_TEST_P(Solver, ReportsItsProgressAndCanBeStopped) {
  expect_progress_and_cancellation<typename TypeParam::Tested>(mesh_of({"lattice", {3000, 6, 0}}));
}

TYPED_TEST_P(Solver, StartsFromAnySeed) {
  const Mesh mesh = mesh_of({"multi-torus", {1500, 2, 0}});
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  for(const Mesh::size_type seed : {1u, mesh.number_of_vertices() / 2}) {
    Pairs pairs;
    solver.template find_loops<typename TypeParam::Tested>(
        std::back_inserter(pairs), CGAL::parameters::seed_vertex(Mesh::Vertex_index(seed)));
    expect_handle_tunnel_pairs(mesh, pairs, 2);
  }
}

// A slow front, a wide one and a fast one.
TYPED_TEST_P(Solver, TakesOtherConstantsOfTheField) {
  std::vector<CGAL::Handle_tunnel_loops::Field_constants> variants(3);
  variants[0].step = 0.02;
  variants[1].gradient_coefficient = 0.2;
  variants[2].driving_force = 0.2;
  const Mesh mesh = mesh_of({"multi-torus", {900, 2, 0}});
  for(const auto& constants : variants) {
    Pairs pairs;
    CGAL::handle_tunnel_loops<typename TypeParam::Tested>(
        mesh, std::back_inserter(pairs),
        CGAL::parameters::solver_options(
            with(&CGAL::Handle_tunnel_loops::Solver_options::field_constants, constants)));
    expect_handle_tunnel_pairs(mesh, pairs, 2);
  }
}

TYPED_TEST_P(Solver, MayLeaveOutTheRefinement) {
  const Mesh mesh = mesh_of({"gyroid", {3000, 5, 0}});
  Pairs pairs;
  CGAL::handle_tunnel_loops<typename TypeParam::Tested>(
      mesh, std::back_inserter(pairs),
      CGAL::parameters::solver_options(
          with(&CGAL::Handle_tunnel_loops::Solver_options::do_refine_handles, false)));
  expect_handle_tunnel_pairs(mesh, pairs, 5);
}

// ---- the small meshes of the corpus

inline std::vector<std::filesystem::path> small_files_of_corpus() {
  constexpr std::uintmax_t largest = 250000; // bytes: about 4000 faces
  std::vector<std::filesystem::path> files;
  for(const std::filesystem::path& file : files_of_corpus())
    if(std::filesystem::file_size(file) < largest)
      files.push_back(file);
  return files;
}

TYPED_TEST_P(Solver, AgreesOnTheCorpus) {
  const auto files = small_files_of_corpus();
  if(files.empty())
    GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
  Compared compared;
  for(const std::filesystem::path& file : files) {
    SCOPED_TRACE(file);
    Mesh mesh;
    ASSERT_TRUE(CGAL::IO::read_polygon_mesh(file.string(), mesh));
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    expect_agreement<typename TypeParam::Tested, typename TypeParam::Expected>(mesh, solver.genus(),
                                                                               &compared);
  }
  compared.expect_classes(0.7);
}

REGISTER_TYPED_TEST_SUITE_P(Solver,
                            AgreesOnGeneratedSurfaces,
                            AgreesOnTheCoarsestSurfaces,
                            TreatsAllComponents,
                            KnowsInsideFromOutside,
                            FindsLoopsOfTheSameClasses,
                            FindsLoopsOfSimilarLengths,
                            ReportsItsProgressAndCanBeStopped,
                            StartsFromAnySeed,
                            TakesOtherConstantsOfTheField,
                            MayLeaveOutTheRefinement,
                            AgreesOnTheCorpus);

#endif // HTL_TEST_SOLVER_AGREEMENT_TESTS_H
