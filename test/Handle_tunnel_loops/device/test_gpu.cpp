// The solver on a real device: it computes what the host computes. Where there is no device, these
// tests are skipped; with HTL_REQUIRE_GPU=1 in the environment the first one fails instead.

#include "Device_agreement.h"
#include "Same_loops.h"
#include "Solver_agreement_tests.h"
#include "Surfaces_for_cells.h"
#include "label_front_on_device.h"
#include "random_input.h"
#include "with.h"

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#endif
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>

#include <cuda_runtime.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace device_agreement;
using CGAL::Handle_tunnel_loops::Device_options;
using CGAL::Handle_tunnel_loops::No_device_exception;
using CGAL::Handle_tunnel_loops::Out_of_device_memory_exception;
using CGAL::Handle_tunnel_loops::Solver_options;
using device::make_cuda_solver;
namespace parameters = CGAL::parameters;

// Why there is no device; empty if there is one.
std::string missing() {
  try {
    make_cuda_solver(flat_mesh_of(Recipe{"torus", {200, 1, 0}}), {});
    return "";
  } catch(const No_device_exception& e) {
    return e.what();
  }
}

class Gpu : public testing::Test
{
protected:
  void SetUp() override {
    const std::string reason = missing();
    if(!reason.empty())
      GTEST_SKIP() << "no CUDA device: " << reason;
  }

  static Pairs find(const Mesh& mesh, const Device_options& options = {}) {
    Pairs pairs;
    CGAL::handle_tunnel_loops<CGAL::Cuda_tag>(
        mesh, std::back_inserter(pairs),
        parameters::solver_options(with(&Solver_options::device, options)));
    return pairs;
  }
};

TEST(Gpu_smoke, ThereIsADeviceIfThereMustBe) {
  const char* required = std::getenv("HTL_REQUIRE_GPU");
  const std::string reason = missing();
  if(reason.empty()) {
    const Mesh mesh = mesh_of(Recipe{"torus", {2000, 1, 0}});
    Pairs pairs;
    CGAL::handle_tunnel_loops<CGAL::Cuda_tag>(mesh, std::back_inserter(pairs));
    EXPECT_EQ(pairs.size(), 1u);
  } else if(required != nullptr && std::string(required) == "1")
    FAIL() << "no CUDA device, but HTL_REQUIRE_GPU=1: " << reason;
  else
    GTEST_SKIP() << "no CUDA device: " << reason;
}

TEST_F(Gpu, AgreesWithTheHostOnSmoothSurfaces) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const auto solver = make_cuda_solver(mesh, {});
    const Index seed = static_cast<Index>(mesh.number_of_vertices() / 2);
    expect_agreement(*solver, mesh, seed, {});
  }
}

TEST_F(Gpu, AgreesWithTheHostOnRandomSurfaces) {
  Random random(1);
  for(int i = 0; i < 40; ++i) {
    const Recipe recipe = random_recipe(random, 10);
    const Field_constants c = i % 2 == 0 ? Field_constants() : random_constants(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    SCOPED_TRACE(testing::Message() << recipe);
    const auto solver = make_cuda_solver(mesh, {});
    expect_agreement(*solver, mesh, static_cast<Index>(random.below(mesh.number_of_vertices())), c);
  }
}

// By the distance of their centres.
void expect_cells_of_host(const Flat_mesh& mesh) {
  for(const Index spacing : surfaces_for_cells::spacings) {
    SCOPED_TRACE(testing::Message() << mesh.number_of_vertices() << " / " << spacing);
    const auto solver = make_cuda_solver(mesh, {});
    surfaces_for_cells::expect_cells_of_host(
        mesh, spacing, [&](First_cells& cells) { return solver->find_first_cells(cells); });
  }
}

TEST_F(Gpu, FindsTheCellsOfTheHost) {
  for(const Flat_mesh& mesh : surfaces_for_cells::meshes())
    expect_cells_of_host(mesh);
}

// More than there are threads.
TEST_F(Gpu, FindsManyCells) {
  expect_cells_of_host(flat_mesh_of(Recipe{"gyroid", {1000000, 250, 0}}));
}

using Device_against_host = Comparison<CGAL::Cuda_tag, CGAL::Sequential_tag, Gpu>;
INSTANTIATE_TYPED_TEST_SUITE_P(On_a_device, Solver, Device_against_host);

#ifdef CGAL_EIGEN3_ENABLED

// The slow solver shares no algorithm with the device: as it agrees with the host, see
// test_agreement, it agrees with the device.
TEST_F(Gpu, AgreesWithTheReference) {
  using CGAL::Reference_tag;
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2, 7}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    ::expect_agreement<Reference_tag, CGAL::Cuda_tag>(mesh, recipe.request.genus);
    if(recipe.kind != "random" && recipe.request.genus > 0)
      expect_similar_lengths<Reference_tag, CGAL::Cuda_tag>(mesh, 0.95, 1.2);
  }
}

#endif

TEST_F(Gpu, LabelsFrontsAsConnectedComponents) {
  Random random(3);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 5}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    expect_front_labels(mesh, random, [&](const std::vector<Time>& times, Time level) {
      return front_labels::label_front_on_device(mesh, times, level);
    });
  }
}

// Large enough to have more vertices than the device has threads.
TEST_F(Gpu, FindsTheLoopsOfTheHost) {
  for(const Recipe& recipe : {Recipe{"torus", {1000000, 1, 0}}, Recipe{"gyroid", {200000, 100, 0}},
                              Recipe{"sponge", {8000, 40, 1}}, Recipe{"random", {2000, 60, 2}}})
  {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    expect_same(find(mesh), find_loops(mesh));
  }
}

TEST_F(Gpu, RunsOnAnyDeviceAndStream) {
  const Mesh mesh = mesh_of(Recipe{"multi-torus", {4000, 3, 0}});
  const Pairs expected = find_loops(mesh);
  int count = 0, before = 0, after = 0;
  ASSERT_EQ(cudaGetDeviceCount(&count), cudaSuccess);
  for(int device = 0; device < count; ++device) {
    ASSERT_EQ(cudaSetDevice(device), cudaSuccess);
    cudaStream_t stream = nullptr;
    ASSERT_EQ(cudaStreamCreate(&stream), cudaSuccess);
    ASSERT_EQ(cudaSetDevice(0), cudaSuccess);
    ASSERT_EQ(cudaGetDevice(&before), cudaSuccess);
    expect_same(find(mesh, {device, stream}), expected);
    ASSERT_EQ(cudaGetDevice(&after), cudaSuccess);
    EXPECT_EQ(after, before) << "another device is current";
    EXPECT_EQ(cudaStreamDestroy(stream), cudaSuccess);
  }
  EXPECT_THROW(find(mesh, {count, nullptr}), No_device_exception);
}

TEST_F(Gpu, RunsInSeveralThreadsAtOnce) {
  const Mesh mesh = mesh_of(Recipe{"lattice", {6000, 12, 0}});
  const Pairs expected = find_loops(mesh);
  std::vector<Pairs> found(4);
  std::vector<std::thread> threads;
  for(Pairs& pairs : found)
    threads.emplace_back([&] { pairs = find(mesh); });
  for(std::thread& thread : threads)
    thread.join();
  for(const Pairs& pairs : found)
    expect_same(pairs, expected);
}

// But for what it keeps for later, until it is asked for that too.
TEST_F(Gpu, GivesBackAllMemory) {
  using CGAL::Handle_tunnel_loops::kept_device_bytes;
  using CGAL::Handle_tunnel_loops::release_device_memory;
  const Mesh mesh = mesh_of(Recipe{"gyroid", {50000, 25, 0}});
  const auto free_bytes = [] {
    std::size_t free = 0, total = 0;
    EXPECT_EQ(cudaMemGetInfo(&free, &total), cudaSuccess);
    return free;
  };
  constexpr std::size_t of_others = 16 << 20; // who may use the device too
  find(mesh);                                 // what the runtime itself takes
  release_device_memory();
  const std::size_t before = free_bytes();
  for(int i = 0; i < 3; ++i) {
    find(mesh);
    EXPECT_GE(free_bytes() + kept_device_bytes + of_others, before);
  }
  release_device_memory();
  EXPECT_GE(free_bytes() + of_others, before);
}

// Where others have taken nearly all of it.
TEST_F(Gpu, RunsInLittleMemory) {
  const Mesh mesh = mesh_of(Recipe{"gyroid", {50000, 25, 0}});
  const Pairs expected = find_loops(mesh);
  CGAL::Handle_tunnel_loops::release_device_memory();
  for(const std::size_t mib : {32, 64, 256}) {
    std::size_t free = 0, total = 0;
    ASSERT_EQ(cudaMemGetInfo(&free, &total), cudaSuccess);
    void* taken = nullptr;
    ASSERT_EQ(cudaMalloc(&taken, free - (mib << 20)), cudaSuccess);
    try {
      expect_same(find(mesh), expected);
    } catch(const Out_of_device_memory_exception& e) {
      EXPECT_EQ(mib, 32u) << e.what(); // some of it the runtime wants
    }
    CGAL::Handle_tunnel_loops::release_device_memory();
    EXPECT_EQ(cudaFree(taken), cudaSuccess);
  }
}

} // namespace
