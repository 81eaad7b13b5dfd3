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

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace htl_cuda {
namespace {

using CGAL::Handle_tunnel_loops::internal::device::Ceilings;

/// A program of steps in which nothing is done.
struct Nothing
{
  Index number_of_steps;

  struct State
  {
    Index step;
  };
  __host__ __device__ State load() const { return {0}; }
  __host__ __device__ void store(const State&) const {}
  __host__ __device__ bool begin_step(State& state) const { return state.step++ < number_of_steps; }
  __host__ __device__ void clear_ahead(const State&) const {}
  __host__ __device__ Index size(const State&) const { return 0; }
  __host__ __device__ void end_step(State&) const {}
  __host__ __device__ void operator()(Index, const State&) const {}
};

/// Copies one array to another.
struct Copy
{
  const float4* from;
  float4* to;
  __host__ __device__ void operator()(Index i) const { to[i] = from[i]; }
};

/// Does nothing.
struct Idle
{
  __host__ __device__ void operator()(Index) const {}
};

// The best of a few runs, after one that does not count.
template <typename Run> double seconds_of(cudaStream_t stream, const Run& run) {
  run();
  double best = 1e9;
  for(int i = 0; i < 5; ++i) {
    Stopwatch stopwatch(stream);
    run();
    best = std::min(best, stopwatch.seconds());
  }
  return best;
}

constexpr Index number_of_tries = 1000;

double seconds_per_step(Cuda_executor& executor, cudaStream_t stream) {
  return seconds_of(stream, [&] { executor.run(Nothing{number_of_tries}, 0); }) / number_of_tries;
}

std::string version_of(int version) {
  return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

} // namespace
} // namespace htl_cuda

namespace CGAL::Handle_tunnel_loops::internal::device {

Ceilings measure_ceilings(int device) {
  using namespace htl_cuda;
  device = usable_device(device);
  const Current_device current(device);
  Ceilings ceilings;
  cudaDeviceProp properties;
  check(cudaGetDeviceProperties(&properties, device), "asking for the properties of the device");
  ceilings.device = properties.name;
  int driver = 0, runtime = 0;
  check(cudaDriverGetVersion(&driver), "asking for the version of the driver");
  check(cudaRuntimeGetVersion(&runtime), "asking for the version of the runtime");
  ceilings.versions = "driver " + version_of(driver) + ", runtime " + version_of(runtime);

  const Stream stream(nullptr);
  Cuda_executor executor(device, stream.get());
  const std::size_t size = std::min<std::size_t>(std::size_t(1) << 26, executor.free_bytes() / 64);
  const auto began = std::chrono::steady_clock::now();
  const Device_buffer<float4> from = executor.make<float4>(size), to = executor.make<float4>(size);
  check(cudaStreamSynchronize(stream.get()), "measuring");
  ceilings.seconds_to_map =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  ceilings.mapped_bytes = 2 * sizeof(float4) * size;
  const double copying = seconds_of(stream.get(), [&] {
    executor.for_each(size, Copy{from.span().data(), to.span().data()});
  });
  ceilings.bytes_per_second = 2. * sizeof(float4) * double(size) / copying;

  ceilings.seconds_per_launch = seconds_of(stream.get(),
                                           [&] {
                                             for(Index i = 0; i < number_of_tries; ++i)
                                               executor.for_each(1, Idle());
                                           }) /
                                number_of_tries;
  ceilings.seconds_per_step = seconds_per_step(executor, stream.get());
  return ceilings;
}

} // namespace CGAL::Handle_tunnel_loops::internal::device
