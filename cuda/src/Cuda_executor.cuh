// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_CUDA_EXECUTOR_CUH
#define HTL_CUDA_CUDA_EXECUTOR_CUH

#include "Device_memory.cuh"
#include "Stopwatch.cuh"
#include "thread_numbers.cuh"

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <cooperative_groups.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <typeinfo>

namespace htl_cuda {

using CGAL::Handle_tunnel_loops::internal::Index;
using CGAL::Handle_tunnel_loops::internal::device::Kernel_cost;
using CGAL::Handle_tunnel_loops::internal::device::Tuning;

constexpr int threads_per_block = 256;

// Of the threads that meet at barriers there is one block on each multiprocessor: the fewer blocks,
// the cheaper the barrier. With more threads there are too few registers to load what belongs to
// all neighbours of a vertex at a time.
constexpr int fewest_threads_at_barrier = 128, most_threads_at_barrier = 640;

template <typename Function> __global__ void for_each_kernel(std::size_t n, Function f) {
  for(std::size_t i = thread_number(); i < n; i += number_of_threads())
    f(static_cast<Index>(i));
}

template <typename Function>
__global__ void for_each_of_kernel(const Index* n, std::size_t limit, Function f) {
  const std::size_t size = *n < limit ? *n : limit;
  for(std::size_t i = thread_number(); i < size; i += number_of_threads())
    f(static_cast<Index>(i));
}

template <typename T> __global__ void fill_kernel(T* data, std::size_t size, T value) {
  for(std::size_t i = thread_number(); i < size; i += number_of_threads())
    data[i] = value;
}

/// The threads of a cooperative launch, for `run_steps()`.
struct Grid_threads
{
  cooperative_groups::grid_group grid;

  __device__ bool is_first() const { return thread_number() == 0; }
  __device__ void wait() { grid.sync(); }
  template <typename Program, typename State>
  __device__ void for_each(Index n, const Program& program, const State& state) const {
    for(std::size_t i = thread_number(); i < n; i += number_of_threads())
      program(static_cast<Index>(i), state);
  }
};

/// All steps of a program in one launch; the barrier between them is that of the grid.
template <typename Program>
__global__ void __launch_bounds__(most_threads_at_barrier, 1) run_kernel(Program program) {
  Grid_threads threads = {cooperative_groups::this_grid()};
  CGAL::Handle_tunnel_loops::internal::run_steps(program, threads);
}

/// Runs on the current device, in the order of a stream: what `Processor_executor` provides, and
/// what is free. The stream must outlive it.
class Cuda_executor
{
public:
  template <typename T> using Buffer = Device_buffer<T>;

  Cuda_executor(int device, cudaStream_t stream, const Tuning& tuning = {})
      : device_(device)
      , memory_(device)
      , stream_(stream)
      , tuning_(tuning) {
    ask(cudaDevAttrMultiProcessorCount, device, number_of_multiprocessors_);
    int most_threads = 0;
    ask(cudaDevAttrMaxThreadsPerBlock, device, most_threads);
    threads_per_block_ = whole_warps(std::min(most_threads, threads_per_block));
    threads_at_barrier_ =
        whole_warps(std::min({most_threads, tuning.threads_at_barrier, most_threads_at_barrier}));
  }
  /// All buffers have been given back by now; what is still to do with them is waited for.
  ~Cuda_executor() { ignore(cudaStreamSynchronize(stream_)); }
  Cuda_executor(const Cuda_executor&) = delete;
  Cuda_executor& operator=(const Cuda_executor&) = delete;

  /// waits for the stream: what is given back counts when it has its turn.
  std::size_t free_bytes() const {
    check(cudaStreamSynchronize(stream_), "running on the device");
    return memory_.free_bytes();
  }
  std::size_t bytes_in_use() const { return memory_.bytes_in_use(); }

  template <typename T> Buffer<T> make(std::size_t size) {
    return Buffer<T>(size, memory_, stream_);
  }

  /// waits for the stream: what is copied from may be gone after the call.
  template <typename T> void upload(const Span<T>& to, const T* from) {
    if(to.empty())
      return;
    check(cudaMemcpyAsync(to.data(), from, to.size() * sizeof(T), cudaMemcpyHostToDevice, stream_),
          "copying to the device");
    check(cudaStreamSynchronize(stream_), "copying to the device");
  }

  /// waits for the stream.
  template <typename T> void download(T* to, const Span<T>& from) {
    if(!from.empty())
      check(cudaMemcpyAsync(to, from.data(), from.size() * sizeof(T), cudaMemcpyDeviceToHost,
                            stream_),
            "copying from the device");
    check(cudaStreamSynchronize(stream_), "running on the device");
  }

  template <typename T> void fill(const Span<T>& span, const T& value) {
    launch(span.size(), fill_kernel<T>, span.data(), span.size(), value);
  }

  template <typename Function> void for_each(std::size_t n, const Function& f) {
    launch(n, for_each_kernel<Function>, n, f);
  }

  template <typename Function>
  void for_each_of(const Index* n, std::size_t limit, const Function& f) {
    launch(std::min<std::size_t>(limit, largest_grid() * threads_per_block_),
           for_each_of_kernel<Function>, n, limit, f);
  }

  /// runs a program of many steps, see `run_steps()`, in one kernel with a barrier of the grid
  /// after each step. There are as many threads as the expected number of items in a step needs.
  template <typename Program> void run(const Program& program, std::size_t expected_items) {
    const std::size_t wanted = std::max(expected_items / number_of_multiprocessors_ + warp_size,
                                        std::size_t(fewest_threads_at_barrier));
    const int threads =
        whole_warps(static_cast<int>(std::min(wanted, std::size_t(threads_at_barrier_))));
    start({number_of_multiprocessors_, threads, true}, run_kernel<Program>, program);
  }

  /// the kernels run so far, if they are timed.
  const std::map<std::string, Kernel_cost>& kernels() const { return kernels_; }

  /// makes its device the current one of the calling thread, as long as what is returned lives.
  Current_device scope() const { return Current_device(device_); }

private:
  // A block has less than a warp or whole ones.
  static int whole_warps(int threads) {
    return threads > int(warp_size) ? threads - threads % int(warp_size) : threads;
  }

  static void ask(cudaDeviceAttr attribute, int device, int& value) {
    check(cudaDeviceGetAttribute(&value, attribute, device), "asking for what the device can do");
  }

  std::size_t largest_grid() const { return std::size_t(number_of_multiprocessors_) * 8; }

  template <typename... Parameters, typename... Arguments>
  void launch(std::size_t n, void (*kernel)(Parameters...), const Arguments&... arguments) {
    if(n == 0)
      return;
    // Few items may each be a long walk: they do not wait for one another in a warp.
    const bool are_few = n <= std::size_t(number_of_multiprocessors_) * warp_size;
    const int threads = are_few ? 1 : threads_per_block_;
    const std::size_t blocks = (n + threads - 1) / threads;
    const std::size_t most = are_few ? blocks : largest_grid();
    start({static_cast<int>(std::min(blocks, most)), threads, false}, kernel, arguments...);
  }

  struct Grid
  {
    int number_of_blocks, threads_per_block;
    bool is_cooperative; ///< whether the blocks meet at barriers
  };

  template <typename... Parameters, typename... Arguments>
  void start(const Grid& grid, void (*kernel)(Parameters...), const Arguments&... arguments) {
    cudaLaunchAttribute cooperative = {};
    cooperative.id = cudaLaunchAttributeCooperative;
    cooperative.val.cooperative = 1;
    cudaLaunchConfig_t configuration = {};
    configuration.gridDim = dim3(static_cast<unsigned>(grid.number_of_blocks));
    configuration.blockDim = dim3(static_cast<unsigned>(grid.threads_per_block));
    configuration.stream = stream_;
    configuration.attrs = &cooperative;
    configuration.numAttrs = grid.is_cooperative ? 1 : 0;
    std::optional<Stopwatch> stopwatch;
    if(tuning_.times_kernels)
      stopwatch.emplace(stream_);
    check(cudaLaunchKernelEx(&configuration, kernel, arguments...), "starting a kernel");
    if(stopwatch) {
      Kernel_cost& cost = kernels_[typeid(kernel).name()];
      ++cost.number_of_launches;
      cost.seconds += stopwatch->seconds();
    }
  }

  int device_;
  Device_memory memory_;
  cudaStream_t stream_;
  Tuning tuning_;
  std::map<std::string, Kernel_cost> kernels_;
  int number_of_multiprocessors_ = 0;
  int threads_per_block_ = 0, threads_at_barrier_ = 0;
};

} // namespace htl_cuda

#endif // HTL_CUDA_CUDA_EXECUTOR_CUH
