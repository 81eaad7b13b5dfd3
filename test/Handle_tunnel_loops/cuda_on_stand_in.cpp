// The library for CUDA devices, compiled for the stand-in for the CUDA runtime.

#include "../../cuda/src/ceilings.cu"
#include "../../cuda/src/cuda_solver.cu"
#include "../../cuda/src/devices.cu"
#include "../../cuda/src/shared_pools.cu"
