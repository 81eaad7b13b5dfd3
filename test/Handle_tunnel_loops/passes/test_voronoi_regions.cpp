// The regions of the sides of loops are what their definition says, and the ways through them are
// tunnels: closed, across their own loop once and across no later one.

#include "Crossing_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Voronoi_search.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace test_voronoi_regions {

using namespace CGAL::Handle_tunnel_loops;
using namespace CGAL::Handle_tunnel_loops::internal;

const auto execution = Execution();

// A surface with the handles of a sweep, and the regions of their sides.
struct Swept_surface
{
  explicit Swept_surface(const Recipe& recipe)
      : mesh(flat_mesh_of(recipe))
      , stencils(execution, mesh)
      , coefficients(step_coefficients(Field_constants()))
      , loops(handles())
      , index(mesh, loops)
      , regions(execution,
                mesh,
                Host_backend(execution, mesh)
                    .times_from_loops(loops, index, coefficients_for_searching(coefficients)),
                loops,
                index) {}

  std::vector<Crossing_loop> handles() const {
    Narrow_band band(mesh, stencils, coefficients);
    const No_walls walls;
    band.add_source(0, 0);
    for(const Index u : mesh.ring(0))
      band.add_source(u, 1);
    band.start(walls);
    while(band.step(walls, [](Index) {}))
      ;
    std::vector<Crossing_loop> found;
    for(const Handle_candidate& handle : find_handle_candidates(execution, mesh, band.take_times()))
      found.push_back(handle.loop);
    return found;
  }

  bool is_edge(Index u, Index v) const { return mesh.ring(u).position(v) < mesh.ring(u).size(); }

  bool is_wall(Index u, Index v) const { return index.is_crossed(u, v, Loops_from{0}); }

  bool is_beside(Voronoi_regions::Region r, Index v) const {
    const Crossing_loop& loop = loops[r / 2];
    return std::any_of(loop.begin(), loop.end(),
                       [&](const Crossing& c) { return c.*Voronoi_regions::side_of(r) == v; });
  }

  Flat_mesh mesh;
  Stencils stencils;
  Step_coefficients coefficients;
  std::vector<Crossing_loop> loops;
  Crossing_index index;
  Voronoi_regions regions;
};

class Regions : public testing::TestWithParam<Recipe>
{};

INSTANTIATE_TEST_SUITE_P(Of_all_kinds,
                         Regions,
                         testing::ValuesIn(recipes_of_all_kinds({1, 3, 10}, 2)),
                         [](const auto& test) {
                           const Request& request = test.param.request;
                           std::string name = test.param.kind + "_g" +
                                              std::to_string(request.genus) + "_s" +
                                              std::to_string(request.seed);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(Regions, LeadEachVertexToALoop) {
  const Swept_surface s(GetParam());
  for(Index v = 0; v < s.mesh.number_of_vertices(); ++v) {
    const auto region = s.regions.region(v);
    ASSERT_LT(region, s.regions.number_of_regions()) << "vertex " << v;
    const std::vector<Index> walk = s.regions.descent(v);
    ASSERT_EQ(walk.front(), v);
    ASSERT_TRUE(s.is_beside(region, walk.back())) << "vertex " << v;
    for(std::size_t i = 0; i + 1 < walk.size(); ++i) {
      ASSERT_TRUE(s.is_edge(walk[i], walk[i + 1]));
      ASSERT_FALSE(s.is_wall(walk[i], walk[i + 1]));
      ASSERT_EQ(s.regions.region(walk[i + 1]), region);
    }
  }
}

TEST_P(Regions, MeetAtGates) {
  const Swept_surface s(GetParam());
  for(Voronoi_regions::Region r = 0; r < s.regions.number_of_regions(); ++r)
    for(Index i = s.regions.gates_begin(r); i < s.regions.gates_begin(r + 1); ++i) {
      const Voronoi_regions::Gate& gate = s.regions.gate(i);
      ASSERT_EQ(gate.from, r);
      ASSERT_NE(gate.to, r);
      if(gate.exit == gate.entry) {
        EXPECT_TRUE(s.is_beside(gate.from, gate.exit));
        EXPECT_TRUE(s.is_beside(gate.to, gate.exit));
      } else {
        EXPECT_TRUE(s.is_edge(gate.exit, gate.entry));
        EXPECT_FALSE(s.is_wall(gate.exit, gate.entry));
        EXPECT_EQ(s.regions.region(gate.exit), gate.from);
        EXPECT_EQ(s.regions.region(gate.entry), gate.to);
      }
    }
}

TEST_P(Regions, OfferTunnels) {
  const Swept_surface s(GetParam());
  Voronoi_graph_search search(s.mesh, s.loops, s.index, s.regions);
  for(Index k = 0; k < s.loops.size(); ++k) {
    const std::vector<Index> walk = search.dual_walk(k);
    if(walk.empty())
      continue; // a way along one loop crosses another that runs close beside it
    for(std::size_t i = 0; i < walk.size(); ++i)
      ASSERT_TRUE(s.is_edge(walk[i], walk[(i + 1) % walk.size()]));
    expect_crossing_loop(s.mesh, pushed_left(s.mesh, walk));
    const Sparse_numbers numbers = s.index.intersections(pushed_left(s.mesh, walk));
    ASSERT_EQ(numbers.count(k), 1u);
    EXPECT_EQ(std::abs(numbers.at(k)), 1);
    EXPECT_EQ(numbers.upper_bound(k), numbers.end());
    EXPECT_EQ(search.dual_walk(k), walk) << "the workspace remembers the last search";
  }
}

// Where loops are apart from each other there is a tunnel for each, about as long as the one that
// two fronts of its own find.
TEST(Regions_of_distant_loops, OfferShortTunnels) {
  for(const Recipe& recipe : std::vector<Recipe>{
          {"torus", {4000, 1, 0}}, {"multi-torus", {12000, 8, 0}}, {"sponge", {30000, 30, 0}}})
  {
    SCOPED_TRACE(testing::Message() << recipe);
    const Swept_surface s(recipe);
    Voronoi_graph_search search(s.mesh, s.loops, s.index, s.regions);
    Bidirectional_front<Loops_from> fronts(s.mesh, s.stencils, s.coefficients, s.index);
    double through_regions = 0., by_fronts = 0.;
    const auto tight_length = [&](const std::vector<Index>& walk) {
      Crossing_loop loop = pushed_left(s.mesh, walk);
      Loop_tightening(s.mesh).tighten(loop);
      return length(s.mesh, loop);
    };
    for(Index k = 0; k < s.loops.size(); ++k) {
      const std::vector<Index> walk = search.dual_walk(k);
      ASSERT_FALSE(walk.empty()) << "loop " << k;
      through_regions += tight_length(walk);
      by_fronts += tight_length(fronts.dual_walks({s.loops, s.index, false, {k}}, k).walks.at(0));
    }
    EXPECT_LT(through_regions, 1.1 * by_fronts);
  }
}

// A search that is out of updates says so, and does not disturb the next one.
TEST(Bidirectional_front, GivesUpWhenItIsToldTo) {
  const Swept_surface s({"torus", {4000, 1, 0}});
  Bidirectional_front<Loops_from> fronts(s.mesh, s.stencils, s.coefficients, s.index);
  const Dual_loop_query query = {s.loops, s.index, false, {0}};
  const Dual_walks found = fronts.dual_walks(query, 0);
  ASSERT_EQ(found.walks.size(), 1u);
  EXPECT_FALSE(found.has_given_up);
  Dual_loop_query short_query = query;
  short_query.number_of_updates = 100;
  const Dual_walks nothing = fronts.dual_walks(short_query, 0);
  EXPECT_TRUE(nothing.walks.empty());
  EXPECT_TRUE(nothing.has_given_up);
  EXPECT_EQ(fronts.dual_walks(query, 0).walks, found.walks);
}

TEST(Host_backend, StopsWhenItIsToldTo) {
  const Swept_surface s({"torus", {4000, 1, 0}});
  Host_backend backend(execution, s.mesh);
  const auto stop = [](double) { return false; };
  EXPECT_THROW(backend.initial_field({0}, s.coefficients, stop), Interrupted_exception);
  EXPECT_THROW(backend.times_from_vertices({0}, s.coefficients, stop), Interrupted_exception);
  EXPECT_THROW(backend.dual_walks({s.loops, s.index, false, {0}}, s.coefficients, stop),
               Interrupted_exception);
}

} // namespace test_voronoi_regions
