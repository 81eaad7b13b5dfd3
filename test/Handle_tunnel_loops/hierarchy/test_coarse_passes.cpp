// Loops that were found on a coarse mesh beside those that were found on the mesh itself.

#include "Loop_definitions.h"
#include "Number_of_cases.h"
#include "Pure_bases.h"
#include "Same_events.h"
#include "Same_loops.h"
#include "with.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <vector>

namespace test_coarse_passes {

namespace params = CGAL::parameters;
using CGAL::Handle_tunnel_loops::Solver_options;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

Solver_options fine_options() { return with(&Solver_options::do_coarsen, false); }

// Large enough to be coarsened.
const std::vector<Recipe> recipes = {
    {"torus", {30000, 1, 0}},   {"knot", {30000, 1, 0}},     {"lattice", {40000, 5, 1}},
    {"gyroid", {40000, 10, 0}}, {"foam", {30000, 4, 0}},     {"sponge", {30000, 10, 0}},
    {"shell", {50000, 6, 0}},   {"random", {30000, 100, 0}}, {"bars", {30000, 10, 0}}};

class Loops : public testing::TestWithParam<Recipe>
{};

INSTANTIATE_TEST_SUITE_P(Surfaces, Loops, testing::ValuesIn(recipes), [](const auto& test) {
  return test.param.kind;
});

// As good, and proved as well.
void expect_as_short(const Recipe& recipe) {
  const Mesh mesh = mesh_of(recipe);
  Solver solver(mesh);
  Pairs coarse, fine;
  solver.find_loops(std::back_inserter(coarse));
  const auto certificate = solver.certificate();
  solver.find_loops(std::back_inserter(fine), params::solver_options(fine_options()));
  ASSERT_EQ(coarse.size(), fine.size());
  EXPECT_TRUE(certificate);
  // Which loops of one component go around another is chance.
  EXPECT_EQ(certificate.handles_bound_inside_alone,
            solver.certificate().handles_bound_inside_alone);
  EXPECT_EQ(certificate.tunnels_bound_outside_alone,
            solver.certificate().tunnels_bound_outside_alone);
  EXPECT_LE(total_length(coarse), 1.02 * total_length(fine));
}

TEST_P(Loops, AreAsShortFromACoarseMesh) { expect_as_short(GetParam()); }

// So large that the coarse mesh has one of its own.
TEST(Loops_of_large_meshes, AreAsShortFromTwoCoarseMeshes) {
  if(are_few_cases_tried())
    GTEST_SKIP() << "takes long: runs with HTL_TEST_CASES=all";
  for(const Recipe& recipe : {Recipe{"torus", {3500000, 1, 0}}, Recipe{"lattice", {3500000, 5, 0}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    expect_as_short(recipe);
  }
}

// The log of fronts, layers and times are those of the mesh itself.
TEST(Coarse_passes, TellOfTheFrontsOnTheMeshItself) {
  const Mesh mesh = mesh_of({"lattice", {30000, 5, 0}});
  Solver solver(mesh);
  const auto told = [&](bool do_coarsen) {
    Solver_options options = with(&Solver_options::do_log_fronts, true);
    options.do_coarsen = do_coarsen;
    std::vector<double> times(mesh.number_of_vertices());
    const auto map =
        boost::make_iterator_property_map(times.begin(), get(boost::vertex_index, mesh));
    solver.find_loops(CGAL::Emptyset_iterator(),
                      params::vertex_value_map(map, params::solver_options(options)));
    return std::make_pair(times, solver.statistics().front_events);
  };
  const auto [times, events] = told(true);
  const auto [fine_times, fine_events] = told(false);
  EXPECT_EQ(times, fine_times);
  EXPECT_EQ(events, fine_events);
  EXPECT_FALSE(events.empty());
}

TEST(Coarse_passes, AreNotAskedForWithoutTightening) {
  const Mesh mesh = mesh_of({"torus", {30000, 1, 0}});
  Solver_options loose = with(&Solver_options::do_tighten, false), fine = loose;
  fine.do_coarsen = false;
  expect_same(find_loops(mesh, params::solver_options(loose)),
              find_loops(mesh, params::solver_options(fine)));
}

// More effort finds nothing longer, where it finds all that there is.
TEST(Search_effort, MakesLoopsShorter) {
  const Mesh mesh = mesh_of({"gyroid", {30000, 25, 0}});
  const auto length = [&](double effort) {
    return total_length(
        find_loops(mesh, params::solver_options(with(&Solver_options::search_effort, effort))));
  };
  EXPECT_LE(length(1.), length(0.));
  EXPECT_LE(length(10.), 1.001 * length(1.));
}

} // namespace test_coarse_passes
