#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_DEVICES_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_DEVICES_H

#include "runtime_calls.h"

#include <cstring>
#include <utility>

// NOLINTBEGIN(readability-identifier-naming): CUDA's names

// ---- errors

inline cudaError_t cudaPeekAtLastError() { return cuda_stand_in::Calls::last_error; }
inline cudaError_t cudaGetLastError() {
  return std::exchange(cuda_stand_in::Calls::last_error, cudaSuccess);
}

inline const char* cudaGetErrorString(cudaError_t error) {
  switch(error) {
  case cudaSuccess:
    return "no error";
  case cudaErrorInvalidValue:
    return "invalid argument";
  case cudaErrorMemoryAllocation:
    return "out of memory";
  case cudaErrorNoDevice:
    return "no CUDA-capable device is detected";
  case cudaErrorInvalidDevice:
    return "invalid device ordinal";
  case cudaErrorInvalidResourceHandle:
    return "invalid resource handle";
  case cudaErrorLaunchFailure:
    return "unspecified launch failure";
  default:
    return "some other error";
  }
}

// ---- devices

inline cudaError_t cudaGetDeviceCount(int* count) {
  return cuda_stand_in::call([&] {
    *count = static_cast<int>(cuda_stand_in::machine.devices.size());
    return *count == 0 ? cudaErrorNoDevice : cudaSuccess;
  });
}

inline cudaError_t cudaGetDevice(int* device) {
  return cuda_stand_in::call([&] {
    *device = cuda_stand_in::machine.current_device;
    return cuda_stand_in::machine.devices.empty() ? cudaErrorNoDevice : cudaSuccess;
  });
}

inline cudaError_t cudaSetDevice(int device) {
  return cuda_stand_in::call_with_effect([&] {
    if(!cuda_stand_in::machine.has(device))
      return cudaErrorInvalidDevice;
    cuda_stand_in::machine.current_device = device;
    return cudaSuccess;
  });
}

inline cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int device) {
  return cuda_stand_in::call([&] {
    if(!cuda_stand_in::machine.has(device))
      return cudaErrorInvalidDevice;
    const cuda_stand_in::Device_kind& kind = cuda_stand_in::machine.devices[device]->kind();
    switch(attribute) {
    case cudaDevAttrMaxThreadsPerBlock:
      *value = kind.threads_per_block;
      return cudaSuccess;
    case cudaDevAttrMultiProcessorCount:
      *value = kind.multiprocessors;
      return cudaSuccess;
    case cudaDevAttrComputeCapabilityMajor:
      *value = kind.compute_capability;
      return cudaSuccess;
    case cudaDevAttrCooperativeLaunch:
      *value = kind.has_cooperative_launches;
      return cudaSuccess;
    case cudaDevAttrMemoryPoolsSupported:
      *value = kind.has_pools;
      return cudaSuccess;
    }
    return cudaErrorInvalidValue;
  });
}

inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int device) {
  return cuda_stand_in::call([&] {
    if(!cuda_stand_in::machine.has(device))
      return cudaErrorInvalidDevice;
    std::strcpy(properties->name, "the processor");
    return cudaSuccess;
  });
}

inline cudaError_t cudaDriverGetVersion(int* version) {
  return cuda_stand_in::call([&] {
    *version = CUDART_VERSION;
    return cudaSuccess;
  });
}

inline cudaError_t cudaRuntimeGetVersion(int* version) { return cudaDriverGetVersion(version); }

// NOLINTEND(readability-identifier-naming)

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_DEVICES_H
