// Cuda_if_available_tag: whatever fails on the device, and whenever, the answer is that of the
// host.

#include "Cuda_runtime_test.h"
#include "Device_agreement.h"
#include "Number_of_cases.h"
#include "Pass_answers.h"
#include "Same_loops.h"
#include "Same_reeb_graphs.h"
#include "Surfaces_for_cells.h"
#include "with.h"

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Passes_on_device.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace test_cuda_fallback {

using namespace cuda_runtime_test;
using namespace device_agreement;
using CGAL::Handle_tunnel_loops::Device_options;
using CGAL::Handle_tunnel_loops::Interrupted_exception;
using CGAL::Handle_tunnel_loops::least_vertices_for_device;
using CGAL::Handle_tunnel_loops::Solver_options;
using CGAL::Handle_tunnel_loops::Statistics;
using cuda_stand_in::all_later;
namespace parameters = CGAL::parameters;

constexpr std::size_t any_size = 0;

Solver_options on_device_from(std::size_t least_vertices) {
  return with(&Solver_options::device, Device_options{1, nullptr, least_vertices});
}

class Cuda_fallback : public Cuda_runtime
{
protected:
  const Execution execution = execution_of<CGAL::Cuda_if_available_tag>();

  // The passes are not on the current device, so that it matters which one is.
  void SetUp() override {
    Device_kind kind;
    kind.multiprocessors = kind.threads_per_block = 1;
    use_devices({kind, kind});
    Host_backend host(execution, flat);
    expected = answers_of(host, flat);
    ASSERT_EQ(expected.walks.size(), 2u);
  }

  Statistics expect_right() const {
    Fallback_backend backend(execution, flat, [this] {
      return device::make_cuda_solver(flat, {1, nullptr, any_size});
    });
    EXPECT_TRUE(answers_of(backend, flat) == expected);
    Statistics statistics;
    backend.report(statistics);
    EXPECT_EQ(statistics.backend == "cuda", statistics.fallback.empty());
    return statistics;
  }

  const Recipe recipe = {"torus", {100, 1, 0}};
  const Flat_mesh flat = flat_mesh_of(recipe);
  Answers expected;
};

// ---- failures

// Each is answered by one of the three.
TEST_F(Cuda_fallback, AnyCallMayFail) {
  std::vector<unsigned> numbers = {1, all_later};
  if(!are_few_cases_tried())
    numbers.push_back(4);
  for(const unsigned number : numbers)
    for(const cudaError_t error : {cudaErrorLaunchFailure, cudaErrorMemoryAllocation}) {
      std::size_t on_device = 0, on_both = 0, on_host = 0;
      expect_survived({1, number, error}, 0, [&] {
        const std::string backend = expect_right().backend;
        ++(backend == "cuda" ? on_device : backend == "host" ? on_host : on_both);
      });
      EXPECT_GT(on_host, 10u);
      EXPECT_GT(on_both, 10u);
      EXPECT_GT(on_device, 0u) << "when no call fails";
    }
}

TEST_F(Cuda_fallback, CellsAreFoundByOneOfThem) {
  using namespace surfaces_for_cells;
  const Coarse_mesh expected_cells[] = {coarse_mesh_of(flat, 4), coarse_mesh_of(flat, 8)};
  for(const cudaError_t error : {cudaErrorLaunchFailure, cudaErrorMemoryAllocation}) {
    std::size_t on_device = 0, on_host = 0;
    expect_survived({1, all_later, error}, 0, [&] {
      Fallback_backend backend(execution, flat, [this] {
        return device::make_cuda_solver(flat, {1, nullptr, any_size});
      });
      const auto find = [&](First_cells& cells) {
        const bool have_found = backend.find_first_cells(cells);
        ++(have_found ? on_device : on_host);
        return have_found;
      };
      expect_same(coarse_mesh_of(flat, 4, execution, find), expected_cells[0]);
      expect_same(coarse_mesh_of(flat, 8, execution, find), expected_cells[1]);
    });
    EXPECT_GT(on_host, 10u);
    EXPECT_GT(on_device, 0u) << "when no call fails";
  }
}

TEST_F(Cuda_fallback, TheLoopsAreThoseOfTheHost) {
  const Mesh mesh = mesh_of(recipe);
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  const auto find = [&](Pairs& pairs) {
    solver.find_loops<CGAL::Cuda_if_available_tag>(
        std::back_inserter(pairs),
        parameters::solver_options(
            with(&Solver_options::do_log_fronts, true, on_device_from(any_size))));
  };
  const Pairs expected_pairs = find_loops(mesh);
  for(const unsigned number : {1u, all_later})
    expect_survived({1, number, cudaErrorLaunchFailure}, 5, [&] {
      Pairs pairs;
      find(pairs);
      expect_same(pairs, expected_pairs);
      EXPECT_EQ(solver.statistics().backend == "cuda", solver.statistics().fallback.empty());
      EXPECT_EQ(solver.statistics().backend == "host",
                solver.statistics().backend.find("cuda") == std::string::npos);
    });
}

// With passes that run at the same time, and so in batches, where memory ends in the middle.
TEST_F(Cuda_fallback, MemoryMayEndInAnyPass) {
  const Recipe sponge = {"sponge", {3000, 16, 1}};
  const Mesh mesh = mesh_of(sponge);
  const Pairs expected_pairs = find_loops(mesh);
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  std::size_t number_of_fallbacks = 0;
  for(unsigned first = 1; first < 3000; first += 1 + first / 4) {
    SCOPED_TRACE(first);
    machine.calls.restart({first, all_later, cudaErrorMemoryAllocation});
    Pairs pairs;
    solver.find_loops<CGAL::Cuda_if_available_tag>(
        std::back_inserter(pairs), parameters::solver_options(on_device_from(any_size)));
    machine.calls.restart();
    expect_same(pairs, expected_pairs);
    number_of_fallbacks += solver.statistics().backend == "cuda, then host";
    EXPECT_TRUE(solver.statistics().device_bytes > 0 || solver.statistics().backend == "host");
  }
  EXPECT_GT(number_of_fallbacks, 5u);
}

// The processor does not sweep anew what the device has swept.
TEST_F(Cuda_fallback, KeepsTheTimesOfADeviceThatFailsLater) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {4000, 1, 0}});
  const Step_coefficients k = step_coefficients(Field_constants());
  Fallback_backend backend(execution, mesh, [&] {
    return device::make_cuda_solver(mesh, {1, nullptr, any_size});
  });
  unsigned calls = 0;
  const auto count = [&](double) { return ++calls > 0; };
  backend.initial_field(mesh.seeds, k, count);
  ASSERT_GT(calls, 0u);
  const std::vector<Time> times = backend.arrival_times();
  machine.calls.restart({1, 1, cudaErrorLaunchFailure});
  backend.times_from_vertices({1}, k, [](double) { return true; });
  machine.calls.restart();
  Statistics statistics;
  backend.report(statistics);
  ASSERT_EQ(statistics.backend, "cuda, then host");
  EXPECT_GT(statistics.device_bytes, 0u);
  calls = 0;
  EXPECT_EQ(backend.arrival_times(), times);
  EXPECT_EQ(calls, 0u) << "of a second sweep";
}

TEST_F(Cuda_fallback, StopsWhenItIsAskedToAfterAFailure) {
  const Mesh mesh = mesh_of(recipe);
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  for(const unsigned first : {1u, 40u, 400u})
    for(unsigned stop = 1; stop < 6; ++stop) {
      machine.calls.restart({first, all_later, cudaErrorLaunchFailure});
      unsigned calls = 0;
      EXPECT_THROW(solver.find_loops<CGAL::Cuda_if_available_tag>(
                       CGAL::Emptyset_iterator(),
                       parameters::solver_options(
                           on_device_from(any_size),
                           parameters::callback([&](double) { return ++calls < stop; }))),
                   Interrupted_exception);
      machine.calls.restart();
    }
}

// ---- Reeb graphs

TEST_F(Cuda_fallback, TheReebGraphIsThatOfTheHost) {
  const Mesh mesh = mesh_of(recipe);
  Reeb_graph_of_mesh expected_graph;
  CGAL::reeb_graph(mesh, expected_graph);
  std::size_t on_both = 0;
  for(const unsigned number : {1u, all_later})
    expect_survived({1, number, cudaErrorLaunchFailure}, 5, [&] {
      Reeb_graph_of_mesh graph;
      const auto statistics = CGAL::reeb_graph<CGAL::Cuda_if_available_tag>(
          mesh, graph, parameters::solver_options(on_device_from(any_size)));
      expect_same(graph, expected_graph);
      EXPECT_EQ(statistics.backend == "cuda", statistics.fallback.empty());
      on_both += statistics.backend == "cuda, then host";
    });
  EXPECT_GT(on_both, 10u);
}

TEST_F(Cuda_fallback, TheReebGraphOfASmallMeshStaysOnTheHost) {
  Reeb_graph_of_mesh graph;
  const auto statistics = CGAL::reeb_graph<CGAL::Cuda_if_available_tag>(
      mesh_of(recipe), graph, parameters::solver_options(on_device_from(1000)));
  EXPECT_EQ(statistics.backend, "host");
  EXPECT_NE(statistics.fallback, "");
  EXPECT_EQ(machine.calls.number(), 0u) << "a device is woken";
}

// ---- the size of the mesh

TEST_F(Cuda_fallback, SmallMeshesStayOnTheHost) {
  const Mesh mesh = mesh_of(recipe);
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  const std::size_t n = mesh.number_of_vertices();
  ASSERT_LT(n, least_vertices_for_device);
  for(const std::size_t least : {least_vertices_for_device, n + 1}) {
    solver.find_loops<CGAL::Cuda_if_available_tag>(
        CGAL::Emptyset_iterator(), parameters::solver_options(on_device_from(least)));
    EXPECT_EQ(solver.statistics().backend, "host");
    EXPECT_NE(solver.statistics().fallback.find(std::to_string(n)), std::string::npos);
    EXPECT_EQ(machine.calls.number(), 0u) << "a device is woken";
  }
  solver.find_loops<CGAL::Cuda_if_available_tag>(CGAL::Emptyset_iterator(),
                                                 parameters::solver_options(on_device_from(n)));
  EXPECT_EQ(solver.statistics().backend, "cuda");
  EXPECT_EQ(solver.statistics().fallback, "");
  const std::size_t largest = std::numeric_limits<std::size_t>::max();
  solver.find_loops<CGAL::Cuda_tag>(CGAL::Emptyset_iterator(),
                                    parameters::solver_options(on_device_from(largest)));
  EXPECT_EQ(solver.statistics().backend, "cuda") << "who asks for a device gets one";
}

} // namespace test_cuda_fallback
