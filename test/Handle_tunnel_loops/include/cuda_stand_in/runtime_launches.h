#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_LAUNCHES_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_LAUNCHES_H

#include "Grid.h"
#include "Kernel.h"
#include "runtime_calls.h"

// NOLINTBEGIN(readability-identifier-naming): CUDA's names

template <typename... Parameters>
cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* attributes, void (*)(Parameters...)) {
  using namespace cuda_stand_in;
  return call([&] {
    if(!machine.current().kind().has_code)
      return cudaErrorNoKernelImageForDevice;
    attributes->maxThreadsPerBlock = machine.current().kind().threads_per_block;
    return cudaSuccess;
  });
}

namespace cuda_stand_in {

inline Grid grid_of(const cudaLaunchConfig_t& configuration) {
  Grid grid = {configuration.gridDim, configuration.blockDim, false};
  for(unsigned i = 0; i < configuration.numAttrs; ++i)
    if(configuration.attrs[i].id == cudaLaunchAttributeCooperative)
      grid.is_cooperative = configuration.attrs[i].val.cooperative != 0;
  return grid;
}

inline cudaError_t error_of(const Grid& grid, const Device& device) {
  if(!grid.is_valid(device.kind()))
    return cudaErrorInvalidConfiguration;
  if(grid.is_cooperative && !grid.fits(device.kind()))
    return cudaErrorCooperativeLaunchTooLarge;
  return cudaSuccess;
}

} // namespace cuda_stand_in

template <typename... Parameters, typename... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* configuration,
                               void (*kernel)(Parameters...),
                               Arguments&&... arguments) {
  using namespace cuda_stand_in;
  return call_for(machine.streams, configuration->stream,
                  [&](const std::shared_ptr<Stream>& stream) {
                    Device& device = stream->device();
                    if(&device != &machine.current())
                      return cudaErrorInvalidResourceHandle;
                    const Grid grid = grid_of(*configuration);
                    const cudaError_t error = error_of(grid, device);
                    if(error == cudaSuccess)
                      stream->put([grid, &device, bound = bound_kernel(kernel, arguments...)] {
                        run_grid(bound, grid, device);
                      });
                    return error;
                  });
}

// NOLINTEND(readability-identifier-naming)

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_LAUNCHES_H
