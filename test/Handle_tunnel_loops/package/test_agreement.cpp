// Other solvers against the sequential one on the host, and each against the definitions. A solver
// is a line in the list of types.

#include "Solver_agreement_tests.h"

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#endif

#include <gtest/gtest.h>

namespace test_agreement {

using Solvers = testing::Types<Comparison<CGAL::Parallel_if_available_tag>
#ifdef CGAL_EIGEN3_ENABLED
                               ,
                               Comparison<CGAL::Reference_tag>
#endif
                               >;
INSTANTIATE_TYPED_TEST_SUITE_P(On_the_host, Solver, Solvers);

#ifdef CGAL_EIGEN3_ENABLED

// ---- the log of the reference solver

template <typename Loops_solver> void expect_log(const Mesh& mesh, const Loops_solver& solver) {
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
  solver.find_loops<CGAL::Reference_tag>(CGAL::Emptyset_iterator());
  expect_log(mesh, solver);
  solver.find_loops(CGAL::Emptyset_iterator());
  EXPECT_TRUE(solver.statistics().front_events.empty()) << "of an earlier run";
}

// Each solver from its own arrival times: how often fronts meet is a matter of the surface alone.
TEST(Front_events, HaveAsManyMergesInBothSolvers) {
  using CGAL::Reference_tag;
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    solver.find_loops<Reference_tag>(CGAL::Emptyset_iterator());
    expect_log(mesh, solver);
    solver.find_loops(CGAL::Emptyset_iterator(),
                      CGAL::parameters::solver_options(
                          with(&CGAL::Handle_tunnel_loops::Solver_options::do_log_fronts, true)));
    expect_log(mesh, solver);
  }
}

TEST(Reference_tag, KnowsWhatIsTooCoarse) {
  using CGAL::Reference_tag;
  const auto is_resolved = [](const Mesh& mesh) {
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    solver.find_loops<Reference_tag>(CGAL::Emptyset_iterator());
    return solver.statistics().resolution.is_resolved();
  };
  EXPECT_TRUE(is_resolved(mesh_of({"multi-torus", {8000, 2, 0}})));
  EXPECT_FALSE(is_resolved(mesh_of(smallest_torus())));
}

#endif

} // namespace test_agreement
