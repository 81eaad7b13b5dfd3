// The library for CUDA devices and the kernels of the tests, compiled for the stand-in for the CUDA
// runtime.

#include "../../../cuda/src/ceilings.cu"
#include "../../../cuda/src/cuda_solver.cu"
#include "../../../cuda/src/devices.cu"
#include "../../../cuda/src/shared_pools.cu"
#include "label_front_on_device.cu"
