// Other solvers against the sequential one on the host, and each against the definitions. A solver
// is a line in the list of types.

#include "Flat_mesh_of_soup.h"
#include "Mesh_corpus.h"
#include "Solver_agreement.h"

#include "generators/Random.h"

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#endif

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace {

template <typename ConcurrencyTag> class Solver : public testing::Test
{};

using Solvers = testing::Types<CGAL::Parallel_if_available_tag
#ifdef CGAL_EIGEN3_ENABLED
                               ,
                               CGAL::Handle_tunnel_loops::Reference_tag
#endif
                               >;
TYPED_TEST_SUITE(Solver, Solvers);

TYPED_TEST(Solver, AgreesOnGeneratedSurfaces) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2, 7}, 2)) {
    SCOPED_TRACE(recipe);
    expect_agreement<TypeParam>(mesh_of(recipe), recipe.request.genus);
  }
}

// Far coarser than the front is wide.
TYPED_TEST(Solver, AgreesOnTheCoarsestSurfaces) {
  expect_agreement<TypeParam>(mesh_of(smallest_torus()), 1);
  generators::Random random(21);
  for(int i = 0; i < 100; ++i) {
    const std::size_t genus = random.below(9);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(100), genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(recipe);
    expect_agreement<TypeParam>(mesh_of(recipe), genus);
  }
}

TYPED_TEST(Solver, TreatsAllComponents) {
  const Soup soup =
      generators::disjoint_union({soup_of({"torus", {800, 1, 0}}), soup_of({"sphere", {200, 0, 0}}),
                                  soup_of({"multi-torus", {1500, 3, 0}}), smallest_torus()});
  expect_agreement<TypeParam>(mesh_of(soup), 5);
  expect_agreement<TypeParam>(mesh_of(generators::permute_vertices(soup, 3)), 5);
}

TYPED_TEST(Solver, KnowsInsideFromOutside) {
  Soup soup = soup_of({"multi-torus", {2000, 2, 0}});
  expect_same_classes<TypeParam>(mesh_of(soup));
  reverse_orientation(soup);
  expect_same_classes<TypeParam>(mesh_of(soup));
}

// Where handles lie beside each other in a thin wall, as in a sponge, a loop that is a streamline
// may bound on neither side; there it is enough that both answers are certified.
TYPED_TEST(Solver, FindsLoopsOfTheSameClasses) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2, 7}, 2))
    if(recipe.kind != "random" && recipe.kind != "sponge") {
      SCOPED_TRACE(recipe);
      expect_same_classes<TypeParam>(mesh_of(recipe));
    }
}

// Streamlines are longer than what was pulled taut, but of the same kind.
TYPED_TEST(Solver, FindsLoopsOfSimilarLengths) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2, 7}, 1))
    if(recipe.kind != "random") {
      SCOPED_TRACE(recipe);
      expect_similar_lengths<TypeParam>(mesh_of(recipe), 0.95, 1.2);
    }
}

TYPED_TEST(Solver, ReportsItsProgressAndCanBeStopped) {
  expect_progress_and_cancellation<TypeParam>(mesh_of({"lattice", {3000, 6, 0}}));
}

TYPED_TEST(Solver, StartsFromAnySeed) {
  const Mesh mesh = mesh_of({"multi-torus", {1500, 2, 0}});
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  for(const Mesh::size_type seed : {1u, mesh.number_of_vertices() / 2}) {
    Pairs pairs;
    solver.template find_loops<TypeParam>(std::back_inserter(pairs),
                                          CGAL::parameters::seed_vertex(Mesh::Vertex_index(seed)));
    expect_handle_tunnel_pairs(mesh, pairs, 2);
  }
}

// A slow front, a wide one and a fast one.
TYPED_TEST(Solver, TakesOtherConstantsOfTheField) {
  std::vector<CGAL::Handle_tunnel_loops::Field_constants> variants(3);
  variants[0].step = 0.02;
  variants[1].gradient_coefficient = 0.2;
  variants[2].driving_force = 0.2;
  const Mesh mesh = mesh_of({"multi-torus", {900, 2, 0}});
  for(const auto& constants : variants) {
    Pairs pairs;
    CGAL::handle_tunnel_loops<TypeParam>(mesh, std::back_inserter(pairs),
                                         CGAL::parameters::field_constants(constants));
    expect_handle_tunnel_pairs(mesh, pairs, 2);
  }
}

TYPED_TEST(Solver, MayLeaveOutTheRefinement) {
  const Mesh mesh = mesh_of({"gyroid", {3000, 5, 0}});
  Pairs pairs;
  CGAL::handle_tunnel_loops<TypeParam>(mesh, std::back_inserter(pairs),
                                       CGAL::parameters::do_refine_handles(false));
  expect_handle_tunnel_pairs(mesh, pairs, 5);
}

// ---- the small meshes of the corpus

std::vector<std::filesystem::path> small_files_of_corpus() {
  constexpr std::uintmax_t largest = 250000; // bytes: about 4000 faces
  std::vector<std::filesystem::path> files;
  for(const std::filesystem::path& file : files_of_corpus())
    if(std::filesystem::file_size(file) < largest)
      files.push_back(file);
  return files;
}

TYPED_TEST(Solver, AgreesOnTheCorpus) {
  const auto files = small_files_of_corpus();
  if(files.empty())
    GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
  for(const std::filesystem::path& file : files) {
    SCOPED_TRACE(file);
    Mesh mesh;
    ASSERT_TRUE(CGAL::IO::read_polygon_mesh(file.string(), mesh));
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    expect_agreement<TypeParam>(mesh, solver.genus());
  }
}

#ifdef CGAL_EIGEN3_ENABLED

// ---- the log of the reference solver

template <typename Solver> void expect_log(const Mesh& mesh, const Solver& solver) {
  using namespace CGAL::Handle_tunnel_loops;
  std::size_t merges = 0, splits = 0, closings = 0;
  for(const Front_event& event : solver.statistics().front_events) {
    merges += event.type == Front_event_type::MERGE;
    splits += event.type == Front_event_type::SPLIT;
    closings += event.type == Front_event_type::CLOSING;
    EXPECT_LT(event.vertex, mesh.number_of_vertices());
  }
  EXPECT_EQ(merges, solver.genus());
  EXPECT_EQ(1 + splits, merges + closings);
}

TEST(Reference_tag, LogsAsManyMergesAsThereArePairs) {
  const Mesh mesh = mesh_of({"lattice", {4000, 8, 0}});
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  solver.find_loops<CGAL::Handle_tunnel_loops::Reference_tag>(CGAL::Emptyset_iterator());
  expect_log(mesh, solver);
  solver.find_loops(CGAL::Emptyset_iterator());
  EXPECT_TRUE(solver.statistics().front_events.empty()) << "of an earlier run";
}

// Each solver from its own arrival times: how often fronts meet is a matter of the surface alone.
TEST(Front_events, HaveAsManyMergesInBothSolvers) {
  using CGAL::Handle_tunnel_loops::Reference_tag;
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    solver.find_loops<Reference_tag>(CGAL::Emptyset_iterator());
    expect_log(mesh, solver);
    solver.find_loops(CGAL::Emptyset_iterator(), CGAL::parameters::do_log_fronts(true));
    expect_log(mesh, solver);
  }
}

TEST(Reference_tag, KnowsWhatIsTooCoarse) {
  using CGAL::Handle_tunnel_loops::Reference_tag;
  const auto is_resolved = [](const Mesh& mesh) {
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    solver.find_loops<Reference_tag>(CGAL::Emptyset_iterator());
    return solver.statistics().resolution.is_resolved();
  };
  EXPECT_TRUE(is_resolved(mesh_of({"multi-torus", {8000, 2, 0}})));
  EXPECT_FALSE(is_resolved(mesh_of(smallest_torus())));
}

#endif

} // namespace
