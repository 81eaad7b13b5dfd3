// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Cuda_executor.cuh"
#include "Stream.cuh"
#include "devices.cuh"

#include <CGAL/Handle_tunnel_loops/internal/device/Device_solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>

namespace CGAL::Handle_tunnel_loops::internal::device {
namespace {

struct Executor_on_stream
{
  Executor_on_stream(int device, cudaStream_t given, const Tuning& tuning)
      : stream(given)
      , executor(device, stream.get(), tuning) {}

  htl_cuda::Stream stream;
  htl_cuda::Cuda_executor executor;
};

/// A `Device_solver` with a stream and an executor of its own.
class Cuda_solver : private Executor_on_stream, public Device_solver<htl_cuda::Cuda_executor>
{
public:
  Cuda_solver(const Flat_mesh& mesh, int device, cudaStream_t given, const Tuning& tuning)
      : Executor_on_stream(device, given, tuning)
      , Device_solver(this->executor, mesh, tuning) {}
};

} // namespace

std::unique_ptr<Solver>
make_cuda_solver(const Flat_mesh& mesh, const Device_options& options, const Tuning& tuning) {
  const int device = htl_cuda::usable_device(options.device);
  const htl_cuda::Current_device current(device);
  return std::make_unique<Cuda_solver>(mesh, device, static_cast<cudaStream_t>(options.stream),
                                       tuning);
}

int current_cuda_device() {
  int device = 0;
  htl_cuda::check<No_device_exception>(cudaGetDevice(&device), "asking for the current device");
  return device;
}

void start_cuda_device(const Device_options& options) { htl_cuda::usable_device(options.device); }

} // namespace CGAL::Handle_tunnel_loops::internal::device
