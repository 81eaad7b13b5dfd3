// What is written for the device, run on the processor in several ways.

#include "Device_agreement.h"
#include "Lower_components.h"
#include "Orders.h"
#include "Random_growth.h"
#include "Surfaces_for_cells.h"
#include "label_front.h"
#include "random_input.h"

#include "Host_executor.h"
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Device_solver.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace test_device_passes {

using namespace device_agreement;
using CGAL::Handle_tunnel_loops::Interrupted_exception;
using Solver = device::Device_solver<Host_executor>;

class Device_backend : public testing::TestWithParam<Order>
{};

INSTANTIATE_TEST_SUITE_P(Orders, Device_backend, all_orders(), name_of_order);

TEST_P(Device_backend, AgreeWithTheHostOnSmoothSurfaces) {
  std::vector<Recipe> recipes = recipes_of_all_kinds({0, 1, 3}, 1);
  recipes.push_back({"hubs", {2000, 3, 0}}); // of which sums are kept on the host
  for(const Recipe& recipe : recipes) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Host_executor executor(GetParam());
    Solver solver(executor, mesh);
    const Index seed = static_cast<Index>(mesh.number_of_vertices() / 2);
    const Tally tally = expect_agreement(solver, mesh, seed, {});
    EXPECT_GE(tally.walks, 2 * mesh.genus);
    EXPECT_GE(tally.given_up, mesh.genus);
  }
}

TEST_P(Device_backend, AgreeWithTheHostOnRandomSurfaces) {
  Random random(1);
  const int number = GetParam() == Order::THREADS ? 20 : 100;
  for(int i = 0; i < number; ++i) {
    const Recipe recipe = random_recipe(random, 10);
    const Field_constants c = i % 2 == 0 ? Field_constants() : random_constants(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Index seed = static_cast<Index>(random.below(mesh.number_of_vertices()));
    SCOPED_TRACE(testing::Message() << recipe << ", seed vertex " << seed << ", constants " << c);
    Host_executor executor(GetParam());
    Solver solver(executor, mesh);
    expect_agreement(solver, mesh, seed, c);
  }
}

// Returns how many cells are left to the host, of how many there are about.
std::pair<std::size_t, std::size_t>
expect_cells_of_host(Order order, const Flat_mesh& mesh, Index spacing) {
  SCOPED_TRACE(testing::Message() << mesh.number_of_vertices() << " / " << spacing);
  Host_executor executor(order);
  Solver solver(executor, mesh);
  const auto find = [&](First_cells& cells) { return solver.find_first_cells(cells); };
  const std::size_t left = surfaces_for_cells::expect_cells_of_host(mesh, spacing, find);
  EXPECT_GT(solver.costs().largest_bytes, 0u);
  return {left, mesh.number_of_vertices() / spacing};
}

TEST_P(Device_backend, FindTheCellsOfTheHost) {
  for(const Flat_mesh& mesh : surfaces_for_cells::meshes())
    for(const Index spacing : surfaces_for_cells::spacings)
      expect_cells_of_host(GetParam(), mesh, spacing);
  Random random(6);
  for(int i = 0; i < 20; ++i)
    expect_cells_of_host(GetParam(), flat_mesh_of(random_recipe(random, 20)),
                         static_cast<Index>(1 + random.below(20)));
}

// Those that are large, and no others.
TEST_P(Device_backend, LeaveLargeCellsToTheHost) {
  const surfaces_for_cells::Surface surface(mesh_of({"torus", {20000, 1, 0}}));
  const Flat_mesh& mesh = surface.flat();
  EXPECT_EQ(expect_cells_of_host(GetParam(), mesh, 16).first, 0u);
  const auto [left, all] = expect_cells_of_host(GetParam(), mesh, 100);
  EXPECT_GT(2 * left, all);
}

// Also if that is found out after many rounds, or in the middle.
TEST_P(Device_backend, LeaveAllCellsToTheHost) {
  using namespace surfaces_for_cells;
  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {60000, 1, 0}});
  const auto n = static_cast<Index>(mesh.number_of_vertices());
  Host_executor executor(GetParam());
  Solver solver(executor, mesh);
  const auto find = [&](First_cells& cells) {
    const bool have_found = solver.find_first_cells(cells);
    EXPECT_EQ(have_found, cells.spacing < n);
    return false;
  };
  for(const Index spacing : {Index(16), n})
    expect_same(coarse_mesh_of(mesh, spacing, Execution(), find), coarse_mesh_of(mesh, spacing));
}

// A field that is given more steps before it counts as being at rest.
TEST_P(Device_backend, AgreeWithTheHostWithSmallSteps) {
  Field_constants c;
  c.step = 1. / 32.;
  for(const Recipe& recipe : {Recipe{"torus", {300, 1, 0}}, Recipe{"random", {150, 3, 2}}}) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Host_executor executor(GetParam());
    Solver solver(executor, mesh);
    expect_agreement(solver, mesh, 0, c);
  }
}

// The handles of other times than those of a field.
void expect_handles_of_host(Order run_order,
                            const Flat_mesh& mesh,
                            const std::vector<Time>& times) {
  Host_executor executor(run_order);
  device::Costs costs;
  const device::Device_mesh<Host_executor> device_mesh(executor, view_of(mesh));
  device::Device_initial_pass<Host_executor> sweep(executor, mesh, device_mesh, {}, costs);
  sweep.set_times(times);
  EXPECT_EQ(sweep.handles(), find_handle_candidates(Execution(), mesh, times));
}

// With times in any order that has one minimum, saddles have many lower components.
TEST_P(Device_backend, FindTheHandlesOfTheHostInAnyOrder) {
  Random random(2);
  Index lower_components = 0;
  for(int i = 0; i < 300; ++i) {
    const Recipe recipe = random_recipe(random, 12);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::size_t width = i % 3 == 0 ? 1 : 1 + random.below(100);
    SCOPED_TRACE(testing::Message() << recipe << ", front of " << width);
    const std::vector<Time> times = Random_growth(mesh, random, width).times();
    expect_handles_of_host(GetParam(), mesh, times);
    lower_components = (std::max)(lower_components, most_lower_components(mesh, times));
  }
  EXPECT_GE(lower_components, 5u) << "the meshes are too harmless";
}

TEST_P(Device_backend, FindTheHandleOfTheSmallestTorusInEveryOrder) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  std::vector<Time> times(7);
  std::iota(times.begin(), times.end(), 0u);
  int left = GetParam() == Order::THREADS ? 200 : 5040;
  do {
    SCOPED_TRACE(testing::PrintToString(times));
    expect_handles_of_host(GetParam(), mesh, times);
  } while(--left > 0 && std::next_permutation(times.begin(), times.end()));
}

// In components without a source nothing is reached.
TEST_P(Device_backend, LeaveComponentsWithoutASource) {
  const Soup torus = soup_of({"torus", {300, 1, 0}}), sphere = soup_of({"sphere", {100, 0, 0}});
  const Soup last = soup_of({"multi-torus", {700, 2, 0}});
  const Flat_mesh mesh = flat_mesh_of(generators::disjoint_union({torus, sphere, last}));
  const Index first_of_sphere = static_cast<Index>(torus.points.size());
  const Index first_of_last = static_cast<Index>(first_of_sphere + sphere.points.size());
  const Step_coefficients k = step_coefficients({});
  Host_executor executor(GetParam());
  Solver solver(executor, mesh);
  Host_backend host(Execution(), mesh);
  const std::vector<Index> vertices = {first_of_last + 3, 0, first_of_last};
  const std::vector<Time> times = solver.times_from_vertices(vertices, k, go_on);
  EXPECT_EQ(times, host.times_from_vertices(vertices, k, go_on));
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    EXPECT_EQ(times[v] == never, v >= first_of_sphere && v < first_of_last);
  const auto stop = [](double) { return false; };
  EXPECT_THROW(solver.times_from_vertices(vertices, k, stop), Interrupted_exception);
}

// In so little memory that the passes of a search must run one after the other, they find the same.
TEST_P(Device_backend, DoNotDependOnTheMemory) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"sponge", {3000, 16, 1}});
  const Step_coefficients k = step_coefficients({});
  Host_executor large(GetParam());
  Solver expected(large, mesh);
  const std::vector<Crossing_loop> contours = loops_of(expected.initial_field({0}, k, go_on));
  const Crossing_index index(mesh, contours);
  const Dual_loop_query search = {contours, index, false, first_numbers(contours.size()),
                                  1,        {},    30000};
  const std::vector<Dual_walks> all = expected.dual_walks(search, k, go_on);
  EXPECT_EQ(expected.costs().largest_batch, contours.size());
  std::size_t number_of_batches = 0;
  for(const std::size_t kib : {1500, 2000}) {
    Host_executor small(GetParam(), kib << 10);
    Solver solver(small, mesh);
    const std::vector<Dual_walks> found = solver.dual_walks(search, k, go_on);
    ASSERT_EQ(found.size(), all.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(found[i].walks, all[i].walks);
    number_of_batches += solver.costs().number_of_batches;
    EXPECT_LE(solver.costs().largest_bytes, kib << 10);
  }
  EXPECT_GT(number_of_batches, 4u);
}

// However often the host looks at what there is.
TEST_P(Device_backend, DoNotDependOnTheLooks) {
  Random random(4);
  for(int i = 0; i < (GetParam() == Order::THREADS ? 5 : 30); ++i) {
    const Recipe recipe = random_recipe(random, 10);
    device::Tuning tuning;
    tuning.steps_per_run = static_cast<Time>(1 + random.below(100));
    tuning.steps_per_look = static_cast<Time>(1 + random.below(200));
    tuning.steps_per_look_if_met = static_cast<Time>(random.below(tuning.steps_per_look));
    SCOPED_TRACE(testing::Message()
                 << recipe << ", steps " << tuning.steps_per_run << ", " << tuning.steps_per_look
                 << ", " << tuning.steps_per_look_if_met);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Host_executor executor(GetParam());
    Solver solver(executor, mesh, tuning);
    expect_agreement(solver, mesh, 0, {});
  }
}

TEST_P(Device_backend, LabelFrontsAsConnectedComponents) {
  Random random(3);
  std::vector<Recipe> recipes = recipes_of_all_kinds({0, 1, 5}, 1);
  for(int i = 0; i < 20; ++i)
    recipes.push_back(random_recipe(random, 20));
  for(const Recipe& recipe : recipes) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Host_executor executor(GetParam());
    SCOPED_TRACE(testing::Message() << recipe);
    expect_front_labels(mesh, random, [&](const std::vector<Time>& times, Time level) {
      return front_labels::label_front(executor, mesh, times, level);
    });
  }
}

TEST_P(Device_backend, StopWhenTheyAreAskedTo) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {2000, 1, 0}});
  const Step_coefficients k = step_coefficients({});
  const auto stop = [](double) { return false; };
  Host_executor executor(GetParam());
  Solver solver(executor, mesh);
  EXPECT_THROW(solver.initial_field({0}, k, stop), Interrupted_exception);
  const std::vector<Crossing_loop> contours = loops_of(solver.initial_field({0}, k, go_on));
  const Crossing_index index(mesh, contours);
  const Dual_loop_query search = {contours, index, false, {0}};
  EXPECT_THROW(solver.dual_walks(search, k, stop), Interrupted_exception);
  EXPECT_EQ(solver.dual_walks(search, k, go_on)[0].walks.size(), 1u);
  EXPECT_GT(executor.bytes_in_use(), 0u);
}

TEST_P(Device_backend, GiveBackAllMemory) {
  Host_executor executor(GetParam());
  {
    const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {500, 5, 3}});
    Solver solver(executor, mesh);
    expect_agreement(solver, mesh, 0, {});
    EXPECT_GT(executor.bytes_in_use(), 0u);
  }
  EXPECT_EQ(executor.bytes_in_use(), 0u);
}

} // namespace test_device_passes
