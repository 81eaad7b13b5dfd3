#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_GRAPHS_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_GRAPHS_H

#include "runtime_launches.h"

#include <vector>

// NOLINTBEGIN(readability-identifier-naming): CUDA's names

inline cudaError_t cudaGraphCreate(cudaGraph_t* graph, unsigned) {
  using namespace cuda_stand_in;
  return call([&] {
    *graph = machine.graphs.add(std::make_shared<Graph>());
    return cudaSuccess;
  });
}

// ---- nodes

inline cudaError_t cudaGraphAddKernelNode(cudaGraphNode_t* node,
                                          cudaGraph_t graph,
                                          const cudaGraphNode_t* after,
                                          std::size_t number_after,
                                          const cudaKernelNodeParams* parameters) {
  using namespace cuda_stand_in;
  return call([&] {
    const auto bind = machine.kernel_types.binder(parameters->func);
    if(bind == nullptr)
      return cudaErrorInvalidDeviceFunction;
    const Grid grid = {parameters->gridDim, parameters->blockDim, false};
    const cudaError_t error = error_of(grid, machine.current());
    if(error == cudaSuccess)
      *node = graph->add({after, after + number_after},
                         [grid, kernel = bind(parameters->kernelParams)](Device& device) {
                           run_grid(kernel, grid, device);
                         });
    return error;
  });
}

namespace cuda_stand_in {

// Conditions are numbers in the memory of the host. So that kernels may be given handles of them,
// these are not the addresses but their complements.
inline cudaGraphConditionalHandle handle_of(unsigned* condition) {
  return ~reinterpret_cast<cudaGraphConditionalHandle>(condition);
}
inline unsigned* condition_of(cudaGraphConditionalHandle handle) {
  return reinterpret_cast<unsigned*>(~handle);
}

} // namespace cuda_stand_in

inline cudaError_t cudaGraphConditionalHandleCreate(cudaGraphConditionalHandle* handle,
                                                    cudaGraph_t graph,
                                                    unsigned default_value,
                                                    unsigned flags) {
  using namespace cuda_stand_in;
  return call_for(machine.graphs, graph, [&](const std::shared_ptr<Graph>& object) {
    if(default_value != 0 || flags != cudaGraphCondAssignDefault)
      return cudaErrorInvalidValue;
    *handle = handle_of(object->add_condition());
    return cudaSuccess;
  });
}

// For kernels.
inline void cudaGraphSetConditional(cudaGraphConditionalHandle handle, unsigned value) {
  *cuda_stand_in::condition_of(handle) = value;
}

// A node that repeats a graph of its own as long as its condition is not zero.
inline cudaError_t cudaGraphAddNode(cudaGraphNode_t* node,
                                    cudaGraph_t graph,
                                    const cudaGraphNode_t* after,
                                    const cudaGraphEdgeData*,
                                    std::size_t number_after,
                                    cudaGraphNodeParams* parameters) {
  using namespace cuda_stand_in;
  return call_for(machine.graphs, graph, [&](const std::shared_ptr<Graph>& object) {
    cudaConditionalNodeParams& loop = parameters->conditional;
    const unsigned* const condition = condition_of(loop.handle);
    if(parameters->type != cudaGraphNodeTypeConditional || loop.type != cudaGraphCondTypeWhile ||
       loop.size != 1 || !object->contains(condition))
      return cudaErrorInvalidValue;
    *node = object->add_loop({after, after + number_after}, condition);
    loop.phGraph_out = &(*node)->body;
    return cudaSuccess;
  });
}

// ---- running

inline cudaError_t cudaGraphInstantiate(cudaGraphExec_t* executable, cudaGraph_t graph, unsigned) {
  using namespace cuda_stand_in;
  return call_for(machine.graphs, graph, [&](const std::shared_ptr<Graph>& object) {
    *executable = machine.executables.add(std::make_shared<Executable_graph>(object));
    return cudaSuccess;
  });
}

inline cudaError_t cudaGraphLaunch(cudaGraphExec_t executable, cudaStream_t stream) {
  using namespace cuda_stand_in;
  return call_for(machine.streams, stream, [&](const std::shared_ptr<Stream>& object) {
    const std::shared_ptr<Executable_graph> graph = machine.executables.find(executable);
    if(graph == nullptr)
      return cudaErrorInvalidResourceHandle;
    object->put([graph = std::weak_ptr<Executable_graph>(graph), &device = object->device()] {
      if(graph.expired())
        complaints.add("a graph is destroyed before it has run");
      else
        graph.lock()->run(device);
    });
    return cudaSuccess;
  });
}

inline cudaError_t cudaGraphExecDestroy(cudaGraphExec_t executable) {
  return cuda_stand_in::destroy(cuda_stand_in::machine.executables, executable);
}

inline cudaError_t cudaGraphDestroy(cudaGraph_t graph) {
  return cuda_stand_in::destroy(cuda_stand_in::machine.graphs, graph);
}

// NOLINTEND(readability-identifier-naming)

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_GRAPHS_H
