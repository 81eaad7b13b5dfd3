// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "devices.cuh"

#include "checks.cuh"

#include <string>

namespace htl_cuda {
namespace {

using CGAL::Handle_tunnel_loops::No_device_exception;

__global__ void any_kernel() {}

void require(int device, cudaDeviceAttr attribute, int least, const char* what) {
  int value = 0;
  check(cudaDeviceGetAttribute(&value, attribute, device), "asking for what the device can do");
  if(value < least)
    throw No_device_exception("device " + std::to_string(device) + " has no " + what);
}

} // namespace

int usable_device(int number) {
  int count = 0;
  check<No_device_exception>(cudaGetDeviceCount(&count), "looking for CUDA devices");
  if(number < 0)
    check<No_device_exception>(cudaGetDevice(&number), "asking for the current device");
  if(number >= count)
    throw No_device_exception("device " + std::to_string(number) +
                              " does not exist; number of devices: " + std::to_string(count));
  require(number, cudaDevAttrComputeCapabilityMajor, 7, "compute capability 7.0");
  require(number, cudaDevAttrCooperativeLaunch, 1, "cooperative launches");
  require(number, cudaDevAttrMemoryPoolsSupported, 1, "memory pools");
  const Current_device current(number);
  cudaFuncAttributes attributes;
  check<No_device_exception>(cudaFuncGetAttributes(&attributes, any_kernel),
                             "loading the code for the device");
  return number;
}

} // namespace htl_cuda
