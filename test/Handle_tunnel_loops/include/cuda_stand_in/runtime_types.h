#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_TYPES_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_TYPES_H

#include "kernel_language.h"

#include <cstddef>

// The types of the CUDA runtime, as far as they are used and as its manual describes them.

#define CUDART_VERSION 13000

namespace cuda_stand_in {
class Stream;
class Event;
class Pool;
} // namespace cuda_stand_in

// NOLINTBEGIN(readability-identifier-naming): CUDA's names

enum cudaError_t {
  cudaSuccess = 0,
  cudaErrorInvalidValue = 1,
  cudaErrorMemoryAllocation = 2,
  cudaErrorInvalidConfiguration = 9,
  cudaErrorInvalidDeviceFunction = 98,
  cudaErrorNoDevice = 100,
  cudaErrorInvalidDevice = 101,
  cudaErrorNoKernelImageForDevice = 209,
  cudaErrorInvalidResourceHandle = 400,
  cudaErrorNotReady = 600,
  cudaErrorIllegalAddress = 700,
  cudaErrorLaunchFailure = 719,
  cudaErrorCooperativeLaunchTooLarge = 720,
  cudaErrorNotSupported = 801
};

using cudaStream_t = cuda_stand_in::Stream*;
using cudaEvent_t = cuda_stand_in::Event*;
using cudaMemPool_t = cuda_stand_in::Pool*;

// ---- devices

enum cudaDeviceAttr {
  cudaDevAttrMaxThreadsPerBlock = 1,
  cudaDevAttrMultiProcessorCount = 16,
  cudaDevAttrComputeCapabilityMajor = 75,
  cudaDevAttrCooperativeLaunch = 95,
  cudaDevAttrMemoryPoolsSupported = 115
};

struct cudaDeviceProp
{
  char name[256];
};

struct cudaFuncAttributes
{
  int maxThreadsPerBlock;
};

// ---- memory

enum cudaMemcpyKind { cudaMemcpyHostToDevice = 1, cudaMemcpyDeviceToHost = 2 };
enum cudaMemAllocationType { cudaMemAllocationTypePinned = 1 };
enum cudaMemLocationType { cudaMemLocationTypeDevice = 1 };

struct cudaMemPoolProps
{
  cudaMemAllocationType allocType;
  struct
  {
    cudaMemLocationType type;
    int id;
  } location;
};

enum cudaMemPoolAttr {
  cudaMemPoolAttrReleaseThreshold = 4,
  cudaMemPoolAttrReservedMemCurrent = 5,
  cudaMemPoolAttrUsedMemCurrent = 7
};

// ---- streams and launches

constexpr unsigned cudaStreamDefault = 0, cudaStreamNonBlocking = 1;

enum cudaLaunchAttributeID { cudaLaunchAttributeCooperative = 2 };

struct cudaLaunchAttribute
{
  cudaLaunchAttributeID id;
  union {
    int cooperative;
  } val;
};

struct cudaLaunchConfig_t
{
  dim3 gridDim, blockDim;
  std::size_t dynamicSmemBytes;
  cudaStream_t stream;
  cudaLaunchAttribute* attrs;
  unsigned numAttrs;
};

// NOLINTEND(readability-identifier-naming)

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_TYPES_H
