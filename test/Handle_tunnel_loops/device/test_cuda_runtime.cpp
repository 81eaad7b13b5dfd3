// The solver for CUDA devices, to the last line: a stand-in for the CUDA runtime runs its kernels
// on the processor, keeps the books, and fails wherever it is asked to.

#include "../../../cuda/src/Cuda_executor.cuh"
#include "../../../cuda/src/Stream.cuh"

#include "Cuda_runtime_test.h"
#include "Device_agreement.h"
#include "Pass_answers.h"
#include "Surfaces_for_cells.h"
#include "label_front_on_device.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace test_cuda_runtime {

using namespace cuda_runtime_test;
using namespace device_agreement;
using CGAL::Handle_tunnel_loops::Device_exception;
using CGAL::Handle_tunnel_loops::Device_options;
using CGAL::Handle_tunnel_loops::Interrupted_exception;
using CGAL::Handle_tunnel_loops::kept_device_bytes;
using CGAL::Handle_tunnel_loops::No_device_exception;
using CGAL::Handle_tunnel_loops::Out_of_device_memory_exception;
using CGAL::Handle_tunnel_loops::release_device_memory;
using device::make_cuda_solver;
using device::measure_ceilings;

// By the number of threads that meet at the barriers of a field, on each multiprocessor.
class Cuda_launch : public Cuda_runtime, public testing::WithParamInterface<int>
{
protected:
  static std::unique_ptr<device::Solver> make_solver(const Flat_mesh& mesh,
                                                     const Device_options& options = {}) {
    device::Tuning tuning;
    tuning.threads_at_barrier = GetParam();
    return make_cuda_solver(mesh, options, tuning);
  }
};

INSTANTIATE_TEST_SUITE_P(Threads, Cuda_launch, testing::Values(1, 640));

// ---- the same as on the host

TEST_P(Cuda_launch, AgreesWithTheHostOnSmoothSurfaces) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const auto solver = make_solver(mesh);
    expect_agreement(*solver, mesh, static_cast<Index>(mesh.number_of_vertices() / 2), {});
  }
}

TEST_P(Cuda_launch, FindsTheCellsOfTheHost) {
  for(const Recipe& recipe : {Recipe{"torus", {3000, 1, 0}}, Recipe{"hubs", {3000, 5, 0}}})
    for(const Index spacing : {4, 16}) {
      SCOPED_TRACE(testing::Message() << recipe << ", " << spacing);
      const surfaces_for_cells::Surface surface(mesh_of(recipe));
      const auto solver = make_solver(surface.flat());
      const auto find = [&](First_cells& cells) { return solver->find_first_cells(cells); };
      const std::size_t left =
          surfaces_for_cells::expect_cells_of_host(surface.flat(), spacing, find);
      EXPECT_LT(10 * left, surface.flat().number_of_vertices() / spacing);
    }
}

TEST_P(Cuda_launch, AgreesWithTheHostOnRandomSurfaces) {
  Random random(1);
  for(int i = 0; i < 20; ++i) {
    const Recipe recipe = random_recipe(random, 10);
    const Field_constants c = i % 2 == 0 ? Field_constants() : random_constants(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    SCOPED_TRACE(testing::Message() << recipe << ", constants " << c);
    const auto solver = make_solver(mesh);
    expect_agreement(*solver, mesh, static_cast<Index>(random.below(mesh.number_of_vertices())), c);
  }
}

TEST_P(Cuda_launch, LabelsFrontsAsConnectedComponents) {
  Random random(3);
  for(int i = 0; i < 20; ++i) {
    const Recipe recipe = random_recipe(random, 10);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    SCOPED_TRACE(testing::Message() << recipe);
    expect_front_labels(mesh, random, [&](const std::vector<Time>& times, Time level) {
      return front_labels::label_front_on_device(mesh, times, level);
    });
  }
}

// From one thread in all to as many blocks as are wanted, of as many threads.
TEST_P(Cuda_launch, RunsOnDevicesOfAllSizes) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {300, 4, 1}});
  for(const auto& [multiprocessors, blocks, threads] :
      {std::tuple(1, 1, 1), std::tuple(3, 9, 1), std::tuple(1, 1, 7)})
  {
    Device_kind kind;
    kind.multiprocessors = multiprocessors;
    kind.blocks_per_multiprocessor = blocks;
    kind.threads_per_block = threads;
    use_devices({kind});
    expect_agreement(*make_solver(mesh), mesh, 0, {});
  }
}

// ---- errors

class Cuda_errors : public Cuda_launch
{
protected:
  // The solver is not on the current device, so that it matters which one is.
  void SetUp() override {
    Device_kind kind;
    kind.multiprocessors = kind.threads_per_block = 1;
    use_devices({kind, kind});
    expected_ = answers_of(*make_solver(mesh), mesh);
    ASSERT_EQ(expected_.handles.size(), 1u);
    ASSERT_EQ(expected_.walks.size(), 2u);
  }

  bool is_right(device::Solver& solver) const { return answers_of(solver, mesh) == expected_; }
  bool is_right() const { return is_right(*make_solver(mesh, {1, nullptr})); }

  void expect_right_answers_or_none(unsigned number_of_failures, cudaError_t error) const {
    expect_survived({1, number_of_failures, error}, 0, [this] { EXPECT_TRUE(is_right()); });
    EXPECT_TRUE(is_right());
  }

  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {100, 1, 0}});

private:
  Answers expected_;
};

INSTANTIATE_TEST_SUITE_P(Threads, Cuda_errors, testing::Values(1));

TEST_P(Cuda_errors, AnyCallMayFail) { expect_right_answers_or_none(1, cudaErrorLaunchFailure); }

TEST_P(Cuda_errors, AnyCallMayRunOutOfMemory) {
  expect_right_answers_or_none(1, cudaErrorMemoryAllocation);
  expect_right_answers_or_none(4, cudaErrorMemoryAllocation);
}

TEST_P(Cuda_errors, TheDeviceMayBeLost) {
  expect_right_answers_or_none(cuda_stand_in::all_later, cudaErrorIllegalAddress);
}

TEST_P(Cuda_errors, SolversGoOnAfterAFailure) {
  expect_survived({1, 1, cudaErrorLaunchFailure}, 2, [this] {
    const auto solver = make_solver(mesh, {1, nullptr});
    try {
      EXPECT_TRUE(is_right(*solver));
    } catch(const Device_exception&) {
      EXPECT_TRUE(is_right(*solver));
    }
  });
}

TEST_P(Cuda_errors, SolversGoOnAfterAnInterruption) {
  const auto solver = make_solver(mesh, {1, nullptr});
  const auto stop = [](double) { return false; };
  const Step_coefficients k = step_coefficients({});
  const std::vector<Crossing_loop> contours = loops_of(solver->initial_field({0}, k, go_on));
  const Crossing_index index(mesh, contours);
  EXPECT_THROW(solver->initial_field({0}, k, stop), Interrupted_exception);
  EXPECT_THROW(solver->dual_walks({contours, index, false, {0}}, k, stop), Interrupted_exception);
  EXPECT_TRUE(is_right(*solver));
}

// An error that the caller has not asked for yet is not one of the solver.
TEST_P(Cuda_errors, ErrorsOfTheCallerAreItsOwn) {
  EXPECT_EQ(cudaSetDevice(2), cudaErrorInvalidDevice);
  EXPECT_TRUE(is_right());
  EXPECT_EQ(cudaGetLastError(), cudaErrorInvalidDevice);
}

// ---- devices

TEST_F(Cuda_runtime, ThereMustBeADeviceThatCanDoIt) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  EXPECT_NO_THROW(make_cuda_solver(mesh, {0, nullptr}));
  EXPECT_NO_THROW(make_cuda_solver(mesh, {-1, nullptr}));
  EXPECT_THROW(make_cuda_solver(mesh, {1, nullptr}), No_device_exception);
  std::vector<Device_kind> incapable(4);
  incapable[0].has_cooperative_launches = false;
  incapable[1].has_pools = false;
  incapable[2].has_code = false;
  incapable[3].compute_capability = 6;
  for(const Device_kind& kind : incapable) {
    use_devices({kind});
    EXPECT_THROW(make_cuda_solver(mesh, {}), No_device_exception);
    EXPECT_THROW(measure_ceilings(0), No_device_exception);
  }
  use_devices({});
  for(const int number : {-1, 0}) {
    EXPECT_THROW(make_cuda_solver(mesh, {number, nullptr}), No_device_exception);
    EXPECT_THROW(measure_ceilings(number), No_device_exception);
  }
}

TEST_P(Cuda_launch, RunsOnTheDeviceAskedFor) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {300, 4, 1}});
  use_devices({Device_kind(), Device_kind(), Device_kind()});
  for(const int device : {1, 2}) {
    const auto solver = make_solver(mesh, {device, nullptr});
    expect_agreement(*solver, mesh, 0, {});
    EXPECT_EQ(machine.current_device, 0);
    EXPECT_GT(machine.devices[device]->number_of_kernels, 0u);
  }
  EXPECT_EQ(machine.devices[0]->number_of_kernels, 0u);
}

// A thread has a current device of its own.
TEST_P(Cuda_launch, RunsInAnotherThreadThanTheOneThatMadeIt) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {300, 4, 1}});
  use_devices({Device_kind(), Device_kind()});
  ASSERT_EQ(cudaSetDevice(1), cudaSuccess);
  auto solver = make_solver(mesh);
  std::thread([&] {
    expect_agreement(*solver, mesh, 0, {});
    solver.reset();
    EXPECT_EQ(machine.current_device, 0);
  }).join();
  EXPECT_EQ(machine.current_device, 1);
  ASSERT_EQ(cudaSetDevice(0), cudaSuccess);
}

// ---- streams

// A stream of the caller, on the device that is current.
class Stream_of_caller
{
public:
  Stream_of_caller() {
    EXPECT_EQ(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), cudaSuccess);
  }
  ~Stream_of_caller() { EXPECT_EQ(cudaStreamDestroy(stream_), cudaSuccess); }
  Stream_of_caller(const Stream_of_caller&) = delete;
  Stream_of_caller& operator=(const Stream_of_caller&) = delete;

  cudaStream_t get() const { return stream_; }

private:
  cudaStream_t stream_ = nullptr;
};

TEST_P(Cuda_launch, UsesNoStreamButTheCallers) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {300, 4, 1}});
  const Stream_of_caller stream, other;
  const auto solver = make_solver(mesh, {0, stream.get()});
  expect_agreement(*solver, mesh, 0, {});
  EXPECT_GT(stream.get()->length(), 0u);
  EXPECT_EQ(other.get()->length(), 0u);
  EXPECT_EQ(machine.streams.size(), 2u);
}

TEST_P(Cuda_launch, RefusesTheStreamOfAnotherDevice) {
  use_devices({Device_kind(), Device_kind()});
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  const Stream_of_caller stream;
  EXPECT_THROW(
      make_solver(mesh, {1, stream.get()})->initial_field({0}, step_coefficients({}), go_on),
      Device_exception);
}

// Two on the same device and one on another, each with a thread of its own.
TEST_P(Cuda_launch, RunsSeveralTimesAtOnce) {
  use_devices({Device_kind(), Device_kind()});
  std::vector<std::thread> threads;
  for(const int device : {0, 0, 1})
    threads.emplace_back([device, seed = threads.size()] {
      const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {300, 4, static_cast<unsigned>(seed)}});
      const auto solver = make_solver(mesh, {device, nullptr});
      expect_agreement(*solver, mesh, 0, {});
      EXPECT_EQ(machine.current_device, 0);
    });
  for(std::thread& thread : threads)
    thread.join();
}

// ---- memory

Device_kind device_with(std::size_t memory) {
  Device_kind kind;
  kind.memory = memory;
  return kind;
}

TEST_P(Cuda_launch, RefusesAMeshThatThereIsNoRoomFor) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"sponge", {3000, 16, 1}});
  constexpr std::size_t memory = 100000;
  use_devices({device_with(memory)});
  std::size_t needed = 0;
  try {
    make_solver(mesh);
    FAIL() << "nothing was thrown";
  } catch(const Out_of_device_memory_exception& e) {
    EXPECT_EQ(e.bytes_free(), memory);
    EXPECT_GT(e.bytes_needed(), memory);
    needed = e.bytes_needed();
  }
  EXPECT_EQ(machine.devices[0]->number_of_kernels, 0u);
  use_devices({device_with(needed - 1)});
  EXPECT_THROW(make_solver(mesh), Out_of_device_memory_exception);
  EXPECT_EQ(machine.devices[0]->number_of_kernels, 0u);
  use_devices({device_with(needed)});
  expect_agreement(*make_solver(mesh), mesh, 0, {});
}

TEST_P(Cuda_launch, DoesNotDependOnTheMemory) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"sponge", {3000, 16, 1}});
  std::size_t number_of_batches = 0;
  for(const std::size_t kib : {1500, 1800, 2500}) {
    use_devices({device_with(kib << 10)});
    const auto solver = make_solver(mesh);
    expect_agreement(*solver, mesh, 0, {});
    EXPECT_LE(solver->costs().largest_bytes, kib << 10);
    number_of_batches += solver->costs().number_of_batches;
  }
  EXPECT_GT(number_of_batches, 20u); // of the twelve that there are with much memory
}

// What a pool has kept in small pieces is there for a large array.
TEST_F(Cuda_runtime, MemoryIsUsedAgainInOtherPieces) {
  constexpr std::size_t size = 1 << 16, number = 16;
  use_devices({device_with(size * number)});
  const htl_cuda::Stream stream(nullptr);
  htl_cuda::Cuda_executor executor(0, stream.get());
  {
    std::vector<htl_cuda::Device_buffer<char>> pieces;
    for(std::size_t i = 0; i < number; ++i)
      pieces.push_back(executor.make<char>(size));
    EXPECT_EQ(executor.bytes_in_use(), size * number);
    EXPECT_EQ(executor.free_bytes(), 0u);
    EXPECT_THROW(executor.make<char>(1), Out_of_device_memory_exception);
  }
  EXPECT_EQ(executor.make<char>(size * number).span().size(), size * number);
  EXPECT_EQ(executor.free_bytes(), size * number);
}

// ---- memory that is kept

TEST_P(Cuda_launch, LaterComputationsUseTheMemoryOfEarlierOnes) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {300, 4, 1}});
  std::size_t kept = 0;
  for(int i = 0; i < 3; ++i) {
    expect_agreement(*make_solver(mesh), mesh, 0, {});
    EXPECT_EQ(machine.pools.size(), 1u);
    EXPECT_EQ(machine.arrays.size(), 0u);
    if(i == 0)
      kept = machine.devices[0]->reserved_bytes();
    EXPECT_EQ(machine.devices[0]->reserved_bytes(), kept);
  }
  EXPECT_GT(kept, 0u);
  release_device_memory();
  EXPECT_EQ(machine.held(), "");
  expect_agreement(*make_solver(mesh), mesh, 0, {});
}

// With the memory that an earlier one has left.
TEST_P(Cuda_errors, AnyCallMayFailOfALaterComputation) {
  for(unsigned first = 1; first < 1000; first += 1 + first / 10) {
    EXPECT_TRUE(is_right());
    machine.calls.restart({first, 1, cudaErrorMemoryAllocation});
    try {
      EXPECT_TRUE(is_right());
    } catch(const Device_exception&) {
    }
    machine.calls.restart();
    EXPECT_EQ(machine.pools.size(), 2u) << "one for each device";
    EXPECT_EQ(machine.arrays.size(), 0u);
    EXPECT_EQ(cudaGetLastError(), cudaSuccess);
  }
}

// An executor with arrays, two of which may be kept.
class Memory_user
{
public:
  explicit Memory_user(std::size_t number_of_arrays)
      : stream_(nullptr)
      , executor_(0, stream_.get()) {
    for(std::size_t i = 0; i < number_of_arrays; ++i)
      arrays_.push_back(executor_.make<char>(array_size));
  }

  static constexpr std::size_t array_size = std::size_t(100) << 20;
  static_assert(kept_device_bytes / array_size == 2, "");

  htl_cuda::Cuda_executor& executor() { return executor_; }

private:
  htl_cuda::Stream stream_;
  htl_cuda::Cuda_executor executor_;
  std::vector<htl_cuda::Device_buffer<char>> arrays_;
};

TEST_F(Cuda_runtime, KeepsNoMoreMemoryThanItSays) {
  use_devices({device_with(4 * Memory_user::array_size)});
  {
    const Memory_user user(4);
  }
  EXPECT_EQ(machine.devices[0]->reserved_bytes(), 2 * Memory_user::array_size);
}

TEST_F(Cuda_runtime, ComputationsAtATimeShareTheMemory) {
  constexpr std::size_t size = Memory_user::array_size;
  use_devices({device_with(4 * size)});
  {
    Memory_user a(2), b(1);
    EXPECT_EQ(a.executor().bytes_in_use(), 2 * size);
    EXPECT_EQ(b.executor().bytes_in_use(), size);
    EXPECT_EQ(a.executor().free_bytes(), size);
    EXPECT_EQ(b.executor().free_bytes(), size);
    EXPECT_THROW(Memory_user(2), Out_of_device_memory_exception);
    EXPECT_EQ(b.executor().free_bytes(), size);
    b.executor().make<char>(size);
    EXPECT_EQ(b.executor().free_bytes(), size);
    EXPECT_EQ(machine.devices[0]->reserved_bytes(), 4 * size);
    release_device_memory();
    EXPECT_EQ(machine.devices[0]->reserved_bytes(), 3 * size) << "what is in use stays so";
    EXPECT_EQ(b.executor().make<char>(size).span().size(), size);
    release_device_memory();
  }
  EXPECT_EQ(machine.held(), "");
}

// ---- ceilings

TEST_F(Cuda_runtime, MeasuresItsCeilings) {
  const device::Ceilings ceilings = measure_ceilings(-1);
  EXPECT_EQ(ceilings.device, "the processor");
  EXPECT_EQ(ceilings.versions, "driver 13.0, runtime 13.0");
  for(const double measured :
      {ceilings.bytes_per_second, ceilings.seconds_per_launch, ceilings.seconds_per_step})
  {
    EXPECT_GT(measured, 0.);
    EXPECT_TRUE(std::isfinite(measured));
  }
}

TEST_F(Cuda_runtime, MeasuringMayFail) {
  Device_kind kind;
  kind.memory = 1 << 16;
  kind.multiprocessors = kind.threads_per_block = 1;
  use_devices({kind, kind});
  expect_survived({1, 1, cudaErrorLaunchFailure}, 3, [] { measure_ceilings(1); });
}

} // namespace test_cuda_runtime
