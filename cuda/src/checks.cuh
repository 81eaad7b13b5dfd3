// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_CHECKS_CUH
#define HTL_CUDA_CHECKS_CUH

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <cuda_runtime.h>

#include <string>

namespace htl_cuda {

/// throws an exception of the given type unless the call of the CUDA runtime succeeded.
template <typename Exception = CGAL::Handle_tunnel_loops::Device_exception>
void check(cudaError_t error, const char* what) {
  if(error == cudaSuccess)
    return;
  cudaGetLastError(); // what can be recovered from is not to be reported again
  throw Exception(std::string(what) + ": " + cudaGetErrorString(error));
}

/// for destructors, which have nobody to tell of an error: it is not to be reported again either.
inline void ignore(cudaError_t error) {
  if(error != cudaSuccess)
    cudaGetLastError();
}

/// Makes a device the current one of the thread, and then the one before it again.
class Current_device
{
public:
  explicit Current_device(int device) {
    check(cudaGetDevice(&before_), "asking for the current device");
    const cudaError_t error = cudaSetDevice(device);
    if(error != cudaSuccess) // which may be that of earlier work, and the device chosen
      ignore(cudaSetDevice(before_));
    check(error, "choosing the device");
  }
  ~Current_device() { ignore(cudaSetDevice(before_)); }
  Current_device(const Current_device&) = delete;
  Current_device& operator=(const Current_device&) = delete;

private:
  int before_ = 0;
};

} // namespace htl_cuda

#endif // HTL_CUDA_CHECKS_CUH
