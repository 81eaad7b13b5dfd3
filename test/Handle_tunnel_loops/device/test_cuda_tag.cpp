// The tags for the device, with a stand-in for the library that runs the device's own code on the
// processor: the same pairs as without a device, typed exceptions, and the fallback.

#define CGAL_LINKED_WITH_CUDA

#include "Same_events.h"
#include "Same_loops.h"
#include "Same_reeb_graphs.h"

#include "Host_executor.h"
#include "Quiet_progress.h"
#include "Surfaces_for_cells.h"
#include "with.h"
#include <CGAL/Handle_tunnel_loops/internal/device/Device_solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Field_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::device {

// As the devices of this test: one that has the memory asked for by its number, in KiB, and none
// with the number -1.
struct Stand_in_memory
{
  explicit Stand_in_memory(std::size_t memory)
      : executor(Host_executor::Order::SHUFFLED, memory) {}

  Host_executor executor;
};

class Stand_in : private Stand_in_memory, public Device_solver<Host_executor>
{
public:
  Stand_in(const Flat_mesh& mesh, std::size_t memory)
      : Stand_in_memory(memory)
      , Device_solver(this->executor, mesh) {}
};

// How often a mesh was sent to one of them.
int number_of_solvers = 0;

std::unique_ptr<Solver>
make_cuda_solver(const Flat_mesh& mesh, const Device_options& options, const Tuning&) {
  ++number_of_solvers;
  if(options.device < 0)
    throw No_device_exception("there is no device in this test");
  return std::make_unique<Stand_in>(mesh, std::size_t(options.device) << 10);
}

int current_cuda_device() { return 0; }

void start_cuda_device(const Device_options&) {}

} // namespace CGAL::Handle_tunnel_loops::internal::device

namespace {

using CGAL::Handle_tunnel_loops::Device_options;
using CGAL::Handle_tunnel_loops::Interrupted_exception;
using CGAL::Handle_tunnel_loops::No_device_exception;
using CGAL::Handle_tunnel_loops::Out_of_device_memory_exception;
using CGAL::Handle_tunnel_loops::Solver_options;
namespace parameters = CGAL::parameters;
using Statistics_of_reeb = CGAL::Handle_tunnel_loops::Reeb_statistics;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

// For meshes of any size.
Device_options device_with(std::size_t kib) { return {static_cast<int>(kib), nullptr, 0}; }

Solver_options on(const Device_options& device) { return with(&Solver_options::device, device); }

const Device_options no_device = {-1, nullptr, 0}, large_device = device_with(1 << 20);

class Cuda : public testing::TestWithParam<Recipe>
{
protected:
  template <typename Tag> Pairs find(const Device_options& options) {
    Pairs pairs;
    solver.find_loops<Tag>(std::back_inserter(pairs), parameters::solver_options(on(options)));
    return pairs;
  }

  template <typename Tag> Statistics_of_reeb find_reeb_graph(const Device_options& options) {
    return CGAL::reeb_graph<Tag>(mesh, graph, parameters::solver_options(on(options)));
  }

  std::size_t needed_kib() {
    try {
      find<CGAL::Cuda_tag>(device_with(0));
    } catch(const Out_of_device_memory_exception& e) {
      return (e.bytes_needed() >> 10) + 1;
    }
    return 0;
  }

  const Mesh mesh = mesh_of(GetParam());
  Solver solver{mesh};
  Reeb_graph_of_mesh graph;
};

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Cuda,
                         testing::Values(Recipe{"torus", {6000, 1, 0}},
                                         Recipe{"gyroid", {8000, 9, 0}},
                                         Recipe{"lattice", {6000, 12, 0}},
                                         Recipe{"sponge", {4000, 20, 1}},
                                         Recipe{"random", {2000, 60, 2}},
                                         Recipe{"random", {400, 10, 3}}),
                         [](const auto& test) {
                           return test.param.kind + "_" + std::to_string(test.param.request.faces);
                         });

TEST_P(Cuda, FindsTheLoopsOfTheHost) {
  const Pairs expected = find_loops(mesh);
  expect_same(find<CGAL::Cuda_tag>(large_device), expected);
  EXPECT_EQ(solver.statistics().backend, "cuda");
  EXPECT_EQ(solver.statistics().fallback, "");
  EXPECT_GT(solver.statistics().device_bytes, 0u);
  expect_same(find<CGAL::Cuda_if_available_tag>(large_device), expected);
  EXPECT_EQ(solver.statistics().backend, "cuda");
}

// In no more memory than the loops take.
TEST_P(Cuda, LogsTheFrontsOfTheHost) {
  const auto log_on = [](const Device_options& device) {
    return parameters::solver_options(with(&Solver_options::do_log_fronts, true, on(device)));
  };
  solver.find_loops(CGAL::Emptyset_iterator(), log_on(no_device));
  const auto expected = solver.statistics().front_events;
  solver.find_loops<CGAL::Cuda_tag>(CGAL::Emptyset_iterator(), log_on(device_with(needed_kib())));
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(solver.statistics().front_events, expected);
  solver.find_loops<CGAL::Cuda_if_available_tag>(CGAL::Emptyset_iterator(), log_on(no_device));
  EXPECT_EQ(solver.statistics().front_events, expected);
  find<CGAL::Cuda_tag>(large_device);
  EXPECT_TRUE(solver.statistics().front_events.empty()) << "nobody asked for them";
}

TEST_P(Cuda, TellsTheLayersAndTimesOfTheHost) {
  Mesh told = mesh;
  const auto layers = told.add_property_map<Mesh::Vertex_index, std::size_t>("v:layer", 0).first;
  const auto times = told.add_property_map<Mesh::Vertex_index, double>("v:time", -1.).first;
  const auto maps = [&](const Device_options& options) {
    return parameters::vertex_layer_map(
        layers, parameters::vertex_value_map(times, parameters::solver_options(on(options))));
  };
  solver.find_loops(CGAL::Emptyset_iterator(), maps({}));
  const std::vector<std::size_t> expected_layers(layers.begin(), layers.end());
  const std::vector<double> expected_times(times.begin(), times.end());
  const auto expect_told_again = [&] {
    EXPECT_TRUE(std::equal(layers.begin(), layers.end(), expected_layers.begin()));
    EXPECT_TRUE(std::equal(times.begin(), times.end(), expected_times.begin()));
    for(const Mesh::Vertex_index v : told.vertices()) {
      layers[v] = 0;
      times[v] = -1.;
    }
  };
  expect_told_again();
  solver.find_loops<CGAL::Cuda_tag>(CGAL::Emptyset_iterator(), maps(device_with(needed_kib())));
  expect_told_again();
  solver.find_loops<CGAL::Cuda_if_available_tag>(CGAL::Emptyset_iterator(), maps(large_device));
  EXPECT_EQ(solver.statistics().backend, "cuda");
  expect_told_again();
  solver.find_loops<CGAL::Cuda_if_available_tag>(CGAL::Emptyset_iterator(), maps(no_device));
  EXPECT_EQ(solver.statistics().backend, "host");
  expect_told_again();
}

// With the memory that it asks for, and with more: the passes of a search run in as many batches as
// it takes.
TEST_P(Cuda, FindsThemInLittleMemory) {
  const Pairs expected = find_loops(mesh);
  for(const std::size_t factor : {1, 2, 5}) {
    const std::size_t kib = factor * needed_kib();
    expect_same(find<CGAL::Cuda_tag>(device_with(kib)), expected);
    EXPECT_LE(solver.statistics().device_bytes, kib << 10);
  }
}

TEST_P(Cuda, ThrowsIfThereIsNoDevice) {
  EXPECT_THROW(find<CGAL::Cuda_tag>(no_device), No_device_exception);
  EXPECT_THROW(find<CGAL::Cuda_tag>({}), No_device_exception);
}

TEST_P(Cuda, SaysHowMuchMemoryItNeeds) {
  try {
    find<CGAL::Cuda_tag>(device_with(8));
    FAIL() << "nothing was thrown";
  } catch(const Out_of_device_memory_exception& e) {
    EXPECT_EQ(e.bytes_free(), 8u << 10);
    EXPECT_GT(e.bytes_needed(), e.bytes_free());
  }
  EXPECT_LE(needed_kib() << 10, 150 * mesh.number_of_faces() + (2 << 20));
  EXPECT_THROW(find<CGAL::Cuda_tag>(device_with(needed_kib() - 2)), Out_of_device_memory_exception);
  expect_same(find<CGAL::Cuda_tag>(large_device), find_loops(mesh)); // nothing was lost
}

TEST_P(Cuda, FallsBackAndSaysSo) {
  const Pairs expected = find_loops(mesh);
  for(const Device_options& options : {no_device, device_with(8)}) {
    expect_same(find<CGAL::Cuda_if_available_tag>(options), expected);
    EXPECT_EQ(solver.statistics().backend, "host");
    EXPECT_NE(solver.statistics().fallback, "");
  }
  expect_same(find<CGAL::Sequential_tag>({}), expected);
  EXPECT_EQ(solver.statistics().fallback, "");
}

// With all fields on the device, the last one too; or all on the processor.
TEST_P(Cuda, FindsTheReebGraphOfTheHost) {
  Reeb_graph_of_mesh expected;
  EXPECT_EQ(CGAL::reeb_graph(mesh, expected).backend, "host");
  EXPECT_EQ(find_reeb_graph<CGAL::Cuda_tag>(device_with(needed_kib())).backend, "cuda");
  expect_same(graph, expected);
  const Statistics_of_reeb there = find_reeb_graph<CGAL::Cuda_if_available_tag>(large_device);
  EXPECT_EQ(there.backend, "cuda");
  EXPECT_EQ(there.fallback, "");
  expect_same(graph, expected);
  for(const Device_options& options : {no_device, device_with(8)}) {
    const Statistics_of_reeb elsewhere = find_reeb_graph<CGAL::Cuda_if_available_tag>(options);
    EXPECT_EQ(elsewhere.backend, "host");
    EXPECT_NE(elsewhere.fallback, "");
    expect_same(graph, expected);
  }
}

TEST_P(Cuda, FindsNoReebGraphWithoutADevice) {
  graph = Reeb_graph_of_mesh(5);
  EXPECT_THROW(find_reeb_graph<CGAL::Cuda_tag>(no_device), No_device_exception);
  EXPECT_THROW(find_reeb_graph<CGAL::Cuda_tag>(device_with(8)), Out_of_device_memory_exception);
  const std::vector<Mesh::Vertex_index> sources = {Mesh::Vertex_index(0)}; // and so no loops
  EXPECT_THROW(CGAL::reeb_graph<CGAL::Cuda_tag>(
                   mesh, graph,
                   parameters::solver_options(on(no_device), parameters::source_vertices(sources))),
               No_device_exception);
  EXPECT_EQ(num_vertices(graph), 5u);
}

// ---- cells found by a device

namespace impl = CGAL::Handle_tunnel_loops::internal;

// As those of `Cuda_tag`, with cells on meshes of any size.
std::shared_ptr<impl::Passes> passes_with_cells(const impl::Flat_mesh& mesh,
                                                std::vector<impl::Index> seeds,
                                                const impl::Pass_options& options) {
  return std::make_shared<impl::Field_passes<impl::device::Solver>>(
      impl::Execution(), mesh, std::move(seeds), options,
      [&mesh, where = options.device] { return impl::device::make_cuda_solver(mesh, where); }, 0);
}

std::shared_ptr<impl::Passes> passes_without(const impl::Flat_mesh& mesh,
                                             std::vector<impl::Index> seeds,
                                             const impl::Pass_options& options) {
  return impl::host_passes(impl::Execution(), mesh, std::move(seeds), options);
}

class Cuda_cells : public testing::Test
{
protected:
  std::vector<impl::Flat_pair> pairs(impl::Make_passes make, const impl::Pass_options& options) {
    impl::device::number_of_solvers = 0;
    statistics = {};
    const auto passes =
        impl::coarse_passes(impl::Execution(), surface.flat(), surface.flat().seeds, options, make);
    return impl::run_passes(*passes, options, Quiet_progress(), statistics);
  }

  void expect_pairs_of_host(const impl::Pass_options& options) {
    const std::vector<impl::Flat_pair> expected = pairs(passes_without, options),
                                       found = pairs(passes_with_cells, options);
    ASSERT_EQ(found.size(), expected.size());
    for(std::size_t k = 0; k < found.size(); ++k) {
      expect_same(found[k].handle, expected[k].handle);
      expect_same(found[k].tunnel, expected[k].tunnel);
    }
  }

  const surfaces_for_cells::Surface surface{mesh_of(Recipe{"lattice", {40000, 5, 0}})};
  CGAL::Handle_tunnel_loops::Statistics statistics;

private:
  static void expect_same(const impl::Crossing_loop& a, const impl::Crossing_loop& b) {
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(),
                           [](const impl::Crossing& c, const auto& d) {
                             return c.left == d.left && c.right == d.right && c.ratio == d.ratio;
                           }));
  }
};

// The fine mesh is sent once, whatever else is asked of it.
TEST_F(Cuda_cells, AreFoundOnTheMeshThatIsSentForThem) {
  impl::Pass_options options;
  options.device = large_device;
  for(const bool do_log_fronts : {false, true}) {
    options.do_log_fronts = do_log_fronts;
    expect_pairs_of_host(options);
    EXPECT_EQ(impl::device::number_of_solvers, 2);
    EXPECT_GT(statistics.device_bytes, 80 * surface.flat().number_of_vertices());
  }
}

// Where there is room for a coarse mesh only.
TEST_F(Cuda_cells, AreFoundByTheHostInLittleMemory) {
  impl::Pass_options options;
  options.device = device_with(2048);
  expect_pairs_of_host(options);
  EXPECT_EQ(statistics.backend, "cuda");
  EXPECT_LE(statistics.device_bytes, 2048u << 10);
}

// ---- interruption

TEST_P(Cuda, StopsWhenItIsAskedTo) {
  std::size_t number_of_calls = 0;
  solver.find_loops<CGAL::Cuda_tag>(
      CGAL::Emptyset_iterator(),
      parameters::solver_options(on(large_device), parameters::callback([&](double) {
                                   ++number_of_calls;
                                   return true;
                                 })));
  for(std::size_t stop = 1; stop <= number_of_calls; stop += 1 + number_of_calls / 3) {
    std::size_t calls = 0;
    EXPECT_THROW(solver.find_loops<CGAL::Cuda_tag>(
                     CGAL::Emptyset_iterator(),
                     parameters::solver_options(on(large_device), parameters::callback([&](double) {
                                                  return ++calls < stop;
                                                }))),
                 Interrupted_exception);
  }
}

} // namespace
