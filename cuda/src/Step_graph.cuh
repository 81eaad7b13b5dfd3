// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_STEP_GRAPH_CUH
#define HTL_CUDA_STEP_GRAPH_CUH

#include "checks.cuh"

#include <CGAL/Handle_tunnel_loops/internal/Flat_mesh.h>

#include <cstddef>

namespace htl_cuda {

using CGAL::Handle_tunnel_loops::internal::Index;

constexpr unsigned warp_size = 32;

/// The first of the elements that a thread of the grid works on, and how far apart they are. Warps
/// are dealt out to the blocks in turn: what is too little for all threads keeps all
/// multiprocessors busy. A block has less than a warp or whole ones.
__device__ inline std::size_t thread_number() {
  const unsigned width = blockDim.x < warp_size ? blockDim.x : warp_size;
  const unsigned warp = threadIdx.x / width, lane = threadIdx.x % width;
  return (std::size_t(warp) * gridDim.x + blockIdx.x) * width + lane;
}
__device__ inline std::size_t number_of_threads() { return std::size_t(gridDim.x) * blockDim.x; }

/// Between the steps of a program, for one thread: the state goes on, and the node that repeats the
/// steps is told whether there is a next one. At first there was no step before.
template <typename Program>
__global__ void between_steps_kernel(Program program,
                                     typename Program::State* state,
                                     bool is_first,
                                     cudaGraphConditionalHandle is_next) {
  if(is_first)
    *state = program.load();
  else
    program.end_step(*state);
  const bool goes_on = program.begin_step(*state);
  if(goes_on)
    program.clear_ahead(*state);
  else
    program.store(*state);
  cudaGraphSetConditional(is_next, goes_on ? 1u : 0u);
}

/// The items of one step.
template <typename Program>
__global__ void step_kernel(Program program, const typename Program::State* state) {
  const typename Program::State now = *state;
  const Index size = program.size(now);
  for(std::size_t i = thread_number(); i < size; i += number_of_threads())
    program(static_cast<Index>(i), now);
}

/// A graph that makes all steps of a program, see `run_steps()`: a while node around two kernels.
template <typename Program> class Step_graph
{
public:
  using State = typename Program::State;

  Step_graph(const Program& program, State* state, int blocks, int threads) {
    try {
      build(program, state, blocks, threads);
    } catch(...) {
      destroy();
      throw;
    }
  }
  ~Step_graph() { destroy(); }
  Step_graph(const Step_graph&) = delete;
  Step_graph& operator=(const Step_graph&) = delete;

  cudaGraphExec_t get() const { return executable_; }

private:
  void build(const Program& program, State* state, int blocks, int threads) {
    check(cudaGraphCreate(&graph_, 0), "making a graph");
    cudaGraphConditionalHandle is_next = 0;
    check(cudaGraphConditionalHandleCreate(&is_next, graph_, 0, cudaGraphCondAssignDefault),
          "making a condition");
    const cudaGraphNode_t begin = add_between_steps(graph_, nullptr, program, state, true, is_next);

    cudaGraphNodeParams parameters = {};
    parameters.type = cudaGraphNodeTypeConditional;
    parameters.conditional.handle = is_next;
    parameters.conditional.type = cudaGraphCondTypeWhile;
    parameters.conditional.size = 1;
    cudaGraphNode_t loop = nullptr;
#if CUDART_VERSION >= 13000
    check(cudaGraphAddNode(&loop, graph_, &begin, nullptr, 1, &parameters), "adding a node");
#else
    check(cudaGraphAddNode(&loop, graph_, &begin, 1, &parameters), "adding a node");
#endif
    const cudaGraph_t body = parameters.conditional.phGraph_out[0];
    const cudaGraphNode_t step = add_kernel<Program, const State*>(
        body, nullptr, {blocks, threads}, step_kernel<Program>, program, state);
    add_between_steps(body, &step, program, state, false, is_next);
    check(cudaGraphInstantiate(&executable_, graph_, 0), "preparing a graph");
  }

  struct Grid
  {
    int blocks, threads;
  };

  static cudaGraphNode_t add_between_steps(cudaGraph_t graph,
                                           const cudaGraphNode_t* after,
                                           const Program& program,
                                           State* state,
                                           bool is_first,
                                           cudaGraphConditionalHandle is_next) {
    return add_kernel<Program, State*, bool, cudaGraphConditionalHandle>(
        graph, after, {1, 1}, between_steps_kernel<Program>, program, state, is_first, is_next);
  }

  template <typename... Parameters>
  static cudaGraphNode_t add_kernel(cudaGraph_t graph,
                                    const cudaGraphNode_t* after,
                                    const Grid& grid,
                                    void (*kernel)(Parameters...),
                                    Parameters... arguments) {
    cudaFuncAttributes attributes; // asked for so that the kernel is loaded before the graph runs
    check(cudaFuncGetAttributes(&attributes, kernel), "loading a kernel");
    void* pointers[] = {&arguments...};
    cudaKernelNodeParams parameters = {};
    parameters.func = reinterpret_cast<void*>(kernel);
    parameters.gridDim = dim3(static_cast<unsigned>(grid.blocks));
    parameters.blockDim = dim3(static_cast<unsigned>(grid.threads));
    parameters.kernelParams = pointers;
    cudaGraphNode_t node = nullptr;
    check(cudaGraphAddKernelNode(&node, graph, after, after == nullptr ? 0 : 1, &parameters),
          "adding a node");
    return node;
  }

  void destroy() {
    if(executable_ != nullptr)
      ignore(cudaGraphExecDestroy(executable_));
    if(graph_ != nullptr)
      ignore(cudaGraphDestroy(graph_));
  }

  cudaGraph_t graph_ = nullptr;
  cudaGraphExec_t executable_ = nullptr;
};

} // namespace htl_cuda

#endif // HTL_CUDA_STEP_GRAPH_CUH
