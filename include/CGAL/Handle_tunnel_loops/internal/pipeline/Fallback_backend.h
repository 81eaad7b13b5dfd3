// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_FALLBACK_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_FALLBACK_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Device_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Host_backend.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The fields of the passes, on a device as long as there is one that does them, else on the
/// processor. A pass that fails on the device begins anew on the processor, and so do all later
/// ones; what the device has found before is kept, since the processor would find the same.
template <typename Execution> class Fallback_backend
{
  using Host = Host_backend<Execution>;
  using Device = Device_backend<Execution>;

public:
  Fallback_backend(const Flat_mesh& mesh, const Step_coefficients& k, const Device_options& options)
      : mesh_(mesh)
      , coefficients_(k) {
    start_device(options, Is_linked_with_cuda<Execution>());
    if(!device_)
      host_ = std::make_unique<Host>(mesh, k);
  }

  void report(Statistics& statistics) const {
    if(device_)
      return device_->report(statistics);
    host_->report(statistics);
    if(is_swept_on_device_)
      statistics.backend = "cuda, then host";
    statistics.device_bytes = device_bytes_;
    statistics.fallback = fallback_;
  }

  std::vector<Handle_candidate> sweep(const std::vector<Index>& seeds, Progress& progress) {
    is_swept_on_device_ = false;
    seeds_ = seeds;
    progress_ = &progress;
    auto handles = run([&](auto& passes) { return passes.sweep(seeds, progress); });
    is_swept_on_device_ = device_ != nullptr;
    return handles;
  }

  const std::vector<Time>& arrival_times() {
    return run([this](auto& passes) -> const std::vector<Time>& {
      ensure_times(passes);
      return passes.arrival_times();
    });
  }

  Front_log front_log() {
    return run([this](auto& passes) {
      ensure_times(passes);
      return passes.front_log();
    });
  }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index) {
    return run([&](auto& passes) { return passes.times_from_loops(loops, index); });
  }

  /// A device calls `f` when all is found: it is never called for a search that fails.
  template <typename Function>
  void search(const Dual_loop_query& search, Progress& progress, const Function& f) {
    const auto found = found_on_device(search, progress);
    if(found)
      Device::hand_out(search, *found, progress, f);
    else
      host_->search(search, progress, f);
  }

private:
  void start_device(const Device_options& options, std::true_type) {
    const std::size_t n = mesh_.number_of_vertices();
    if(n < options.least_vertices) {
      fallback_ = "a mesh of " + std::to_string(n) + " vertices does not pay for a device, but " +
                  std::to_string(options.least_vertices) + " do";
      return;
    }
    try {
      device_ = std::make_unique<Device>(mesh_, coefficients_, options);
    } catch(const Device_exception& e) {
      fallback_ = e.what();
    }
  }

  void start_device(const Device_options&, std::false_type) {
    fallback_ = "the program is not linked with Handle_tunnel_loops::cuda";
  }

  // The answer of a pass: the device's, or that of the host if the device has failed.
  template <typename Pass> decltype(auto) run(const Pass& pass) {
    if(device_)
      try {
        return pass(*device_);
      } catch(const Device_exception& e) {
        leave_device(e);
      }
    return pass(*host_);
  }

  std::optional<std::vector<Dual_walks>> found_on_device(const Dual_loop_query& search,
                                                         Progress& progress) {
    if(device_)
      try {
        return device_->found_walks(search, progress);
      } catch(const Device_exception& e) {
        leave_device(e);
      }
    return std::nullopt;
  }

  void leave_device(const Device_exception& e) {
    fallback_ = e.what();
    Statistics statistics;
    device_->report(statistics);
    device_bytes_ = statistics.device_bytes;
    std::vector<Time> times;
    if(is_swept_on_device_)
      times = times_if_there();
    device_.reset();
    host_ = std::make_unique<Host>(mesh_, coefficients_);
    host_->set_sweep_times(std::move(times));
  }

  // A device that has failed in a later pass may still have them.
  std::vector<Time> times_if_there() {
    try {
      return device_->arrival_times();
    } catch(const Device_exception&) {
      return {};
    }
  }

  static void ensure_times(const Device&) {}
  // All sweeps from the same vertices are the same.
  void ensure_times(Host& host) const {
    if(host.arrival_times().empty())
      host.sweep(seeds_, *progress_);
  }

  const Flat_mesh& mesh_;
  Step_coefficients coefficients_;
  std::unique_ptr<Device> device_; // one of the two
  std::unique_ptr<Host> host_;
  std::string fallback_;
  std::size_t device_bytes_ = 0; // of the device that failed
  bool is_swept_on_device_ = false;
  std::vector<Index> seeds_;
  Progress* progress_ = nullptr; // of the last sweep
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_FALLBACK_BACKEND_H
