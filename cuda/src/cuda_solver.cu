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
#include <CGAL/Handle_tunnel_loops/internal/device/make_cuda_solver.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {
namespace {

/// A `Device_solver` that chooses its device in each call.
class Cuda_solver : public Solver
{
public:
  Cuda_solver(const Flat_mesh& mesh, int device, void* stream, const Tuning& tuning)
      : device_(device)
      , stream_(static_cast<cudaStream_t>(stream))
      , executor_(device, stream_.get(), tuning)
      , solver_(executor_, mesh, tuning) {}

  std::vector<Handle_candidate> sweep(const std::vector<Index>& seeds,
                                      const Step_coefficients& k,
                                      const Callback& callback) override {
    const htl_cuda::Current_device current(device_);
    return solver_.sweep(seeds, k, callback);
  }

  std::vector<Time> arrival_times() override {
    const htl_cuda::Current_device current(device_);
    return solver_.arrival_times();
  }

  Front_log front_log() override {
    const htl_cuda::Current_device current(device_);
    return solver_.front_log();
  }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k) override {
    const htl_cuda::Current_device current(device_);
    return solver_.times_from_loops(loops, index, k);
  }

  std::vector<Dual_walks> search(const Dual_loop_query& search,
                                 const Step_coefficients& k,
                                 const Callback& callback) override {
    const htl_cuda::Current_device current(device_);
    return solver_.search(search, k, callback);
  }

  Costs costs() const override {
    Costs costs = solver_.costs();
    costs.kernels = executor_.kernels();
    return costs;
  }

private:
  int device_;
  htl_cuda::Stream stream_;
  htl_cuda::Cuda_executor executor_;
  Device_solver<htl_cuda::Cuda_executor> solver_;
};

} // namespace

std::unique_ptr<Solver>
make_cuda_solver(const Flat_mesh& mesh, const Device_options& options, const Tuning& tuning) {
  const int device = htl_cuda::usable_device(options.device);
  const htl_cuda::Current_device current(device);
  return std::make_unique<Cuda_solver>(mesh, device, options.stream, tuning);
}

int current_cuda_device() {
  int device = 0;
  htl_cuda::check<No_device_exception>(cudaGetDevice(&device), "asking for the current device");
  return device;
}

void start_cuda_device(const Device_options& options) { htl_cuda::usable_device(options.device); }

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL
