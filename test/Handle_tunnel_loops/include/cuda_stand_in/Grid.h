#ifndef HTL_TEST_CUDA_STAND_IN_GRID_H
#define HTL_TEST_CUDA_STAND_IN_GRID_H

#include "Kernel.h"
#include "kernel_language.h"

#include "Host_executor.h"

#include <thread>
#include <vector>

namespace cuda_stand_in {

using CGAL::Handle_tunnel_loops::internal::Barrier;

// The threads that run a kernel, numbered along one axis.
struct Grid
{
  dim3 blocks, block;
  bool is_cooperative;

  unsigned number_of_threads() const { return blocks.size() * block.size(); }
  bool is_valid(const Device_kind& kind) const {
    return blocks.x != 0 && block.x != 0 && blocks.size() == blocks.x && block.size() == block.x &&
           block.x <= static_cast<unsigned>(kind.threads_per_block);
  }
  bool fits(const Device_kind& kind) const {
    return blocks.x <= static_cast<unsigned>(kind.multiprocessors * kind.blocks_per_multiprocessor);
  }
};

// That of the cooperative launch that the thread is part of.
inline thread_local Barrier* barrier_of_grid = nullptr;

inline void run_thread(const Kernel& kernel, const Grid& grid, unsigned number) {
  gridDim = grid.blocks;
  blockDim = grid.block;
  blockIdx = {number / grid.block.x, 0, 0};
  threadIdx = {number % grid.block.x, 0, 0};
  kernel.thread();
}

// In threads of their own, which may wait for each other.
inline void run_together(const Kernel& kernel, const Grid& grid) {
  Barrier barrier(grid.number_of_threads());
  const auto run = [&](unsigned number) {
    barrier_of_grid = &barrier;
    run_thread(kernel, grid, number);
    barrier_of_grid = nullptr;
  };
  std::vector<std::thread> threads;
  for(unsigned i = 1; i < grid.number_of_threads(); ++i)
    threads.emplace_back(run, i);
  run(0);
  for(std::thread& thread : threads)
    thread.join();
}

// Threads that do not wait for each other run one after the other, the last one first.
inline void run_grid(const Kernel& kernel, const Grid& grid, Device& device) {
  check_addresses(kernel, device);
  ++device.number_of_kernels;
  if(grid.is_cooperative)
    return run_together(kernel, grid);
  for(unsigned i = grid.number_of_threads(); i-- > 0;)
    run_thread(kernel, grid, i);
}

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_GRID_H
