// What is asked of callers is checked where assertions are on, as they are in this file.

#define CGAL_HANDLE_TUNNEL_LOOPS_IMPLEMENTATION
#include "handle_tunnel_loops_single.hpp"

#include "Changed_loops.h"
#include "Flat_mesh_of_soup.h"
#include "Loop_definitions.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <CGAL/assertions_behaviour.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

#if defined(CGAL_NO_PRECONDITIONS) || !defined(CGAL_CHECK_EXPENSIVE)
#error "the assertions of CGAL are off"
#endif

namespace {

using namespace CGAL::Handle_tunnel_loops::internal;

class Preconditions : public testing::Test
{
protected:
  Preconditions()
      : behaviour_(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION)) {
    CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
  }
  ~Preconditions() override { CGAL::set_error_behaviour(behaviour_); }

  static Pairs found(const Mesh& mesh) {
    Pairs pairs;
    CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
    return pairs;
  }

private:
  CGAL::Failure_behaviour behaviour_;
};

TEST_F(Preconditions, HoldForWhatIsRight) {
  const Mesh mesh = mesh_of({"lattice", {3000, 6, 0}});
  EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(mesh, found(mesh))));
}

TEST_F(Preconditions, WantTheLoopsOfTheMesh) {
  const Mesh small = mesh_of({"torus", {200, 1, 0}}), large = mesh_of({"torus", {2000, 1, 0}});
  std::vector<Steps> steps = steps_of(found(small));
  steps[0][1].halfedge = *std::prev(halfedges(large).end());
  EXPECT_THROW(CGAL::certify_handle_tunnel_loops(small, pairs_of(steps)),
               CGAL::Precondition_exception);
}

TEST_F(Preconditions, WantTheMeshToStayAsItIs) {
  Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  CGAL::Euler::add_center_vertex(*halfedges(mesh).begin(), mesh);
  EXPECT_THROW(solver.find_loops(CGAL::Emptyset_iterator()), CGAL::Precondition_exception);
}

TEST_F(Preconditions, WantUniqueIndices) {
  const Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  const auto zero = boost::make_function_property_map<Mesh::Vertex_index, std::size_t>(
      [](Mesh::Vertex_index) { return 0; });
  EXPECT_ANY_THROW(
      CGAL::Handle_tunnel_loops_solver<Mesh>(mesh, CGAL::parameters::vertex_index_map(zero)));
}

TEST_F(Preconditions, WantCrossingsThatFollowEachOther) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {200, 1, 0}});
  Crossing_loop loop = {{0, mesh.ring(0)[0], 0.5}, {100, mesh.ring(100)[0], 0.5}};
  EXPECT_THROW(Loop_tightening(mesh).tighten(loop), CGAL::Precondition_exception);
}

TEST_F(Preconditions, WantLowerAndHigherVertices) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {200, 1, 0}});
  EXPECT_THROW(find_lower_components(mesh.ring(0), [](Index) { return true; }),
               CGAL::Precondition_exception);
}

} // namespace
