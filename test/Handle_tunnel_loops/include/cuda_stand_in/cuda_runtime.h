#ifndef HTL_TEST_CUDA_STAND_IN_CUDA_RUNTIME_H
#define HTL_TEST_CUDA_STAND_IN_CUDA_RUNTIME_H

// Stands in for the CUDA runtime: its functions, as far as they are used, do on the processor what
// the manual says that they do on a device.

#include "runtime_devices.h"
#include "runtime_launches.h"
#include "runtime_memory.h"
#include "runtime_streams.h"

#endif // HTL_TEST_CUDA_STAND_IN_CUDA_RUNTIME_H
