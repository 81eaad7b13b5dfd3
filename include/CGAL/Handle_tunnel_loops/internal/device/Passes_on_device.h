// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PASSES_ON_DEVICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PASSES_ON_DEVICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/device_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Field_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// On a device as long as there is one that does it, else on the processor. What fails on the
/// device begins anew on the processor, and so does all that comes later; what the device has found
/// before is kept, since the processor would find the same.
class Fallback_backend
{
public:
  /// \p make_device may throw `Device_exception`.
  Fallback_backend(Execution execution,
                   const Flat_mesh& mesh,
                   const std::function<std::unique_ptr<device::Solver>()>& make_device)
      : execution_(execution)
      , mesh_(mesh) {
    try {
      device_ = make_device();
    } catch(const No_device_exception& e) {
      host_.emplace(execution, mesh, e.what());
    } catch(const Device_exception& e) {
      host_.emplace(execution, mesh, e.what());
      has_device_failed_ = true;
    }
  }

  bool find_first_cells(First_cells& cells) {
    return run([&](auto& backend) { return backend.find_first_cells(cells); });
  }

  std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                              const Step_coefficients& k,
                                              const Callback& callback) {
    is_initial_field_of_device_ = false;
    repeat_ = [this, seeds, k, callback] {
      host_->initial_field(seeds, k, [&](double) { return callback(0.); });
    };
    auto handles = run([&](auto& backend) { return backend.initial_field(seeds, k, callback); });
    is_initial_field_of_device_ = device_ != nullptr;
    return handles;
  }

  std::vector<Time> arrival_times() {
    return run_on_times([](auto& backend) { return backend.arrival_times(); });
  }

  Front_log front_log() {
    return run_on_times([](auto& backend) { return backend.front_log(); });
  }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k) {
    return run([&](auto& backend) { return backend.times_from_loops(loops, index, k); });
  }

  std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                        const Step_coefficients& k,
                                        const Callback& callback) {
    return run([&](auto& b) { return b.times_from_vertices(vertices, k, callback); });
  }

  std::vector<Dual_walks>
  dual_walks(const Dual_loop_query& query, const Step_coefficients& k, const Callback& callback) {
    return run([&](auto& backend) { return backend.dual_walks(query, k, callback); });
  }

  void report(Statistics& statistics) const {
    if(device_)
      return device_->report(statistics);
    CGAL_assertion(host_.has_value());
    host_->report(statistics);
    if(is_initial_field_of_device_)
      statistics.backend = "cuda, then host";
    statistics.device_bytes = (std::max)(statistics.device_bytes, device_bytes_);
    statistics.has_device_failed = has_device_failed_;
  }

private:
  // The answer of the device, or that of the processor if the device fails.
  template <typename Function>
  std::invoke_result_t<Function, Host_backend&> run(const Function& f) {
    CGAL_assertion((device_ != nullptr) != host_.has_value());
    if(device_)
      try {
        return f(*device_);
      } catch(const Device_exception& e) {
        leave_device(e);
      }
    return f(*host_);
  }

  // The same of what rests on the last initial field.
  template <typename Function>
  std::invoke_result_t<Function, Host_backend&> run_on_times(const Function& f) {
    return run([&](auto& backend) {
      if(!device_ && !host_->has_arrival_times()) {
        CGAL_assertion_msg(repeat_ != nullptr, "there was no initial field");
        repeat_();
      }
      return f(backend);
    });
  }

  void leave_device(const Device_exception& e) {
    Statistics statistics;
    device_->report(statistics);
    device_bytes_ = statistics.device_bytes;
    std::vector<Time> times;
    if(is_initial_field_of_device_)
      times = times_if_there();
    device_.reset();
    has_device_failed_ = true;
    host_.emplace(execution_, mesh_, e.what());
    host_->set_arrival_times(std::move(times));
  }

  // A device that has failed in a later pass may still have them.
  std::vector<Time> times_if_there() {
    try {
      return device_->arrival_times();
    } catch(const Device_exception&) {
      return {};
    }
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::unique_ptr<device::Solver> device_; // one of the two
  std::optional<Host_backend> host_;
  std::size_t device_bytes_ = 0; // of the device that failed
  bool has_device_failed_ = false;
  bool is_initial_field_of_device_ = false;
  std::function<void()> repeat_; // the last initial field
};

namespace device {

/// On meshes of so many vertices cells are found by a device that is started: the mesh has to be
/// sent to it, and cells have to be sent back.
constexpr std::size_t least_vertices_for_cells = 400000;

inline std::unique_ptr<Solver> solver_if_worth_it(const Flat_mesh& mesh,
                                                  const Device_options& options) {
  const std::size_t n = mesh.number_of_vertices();
  if(n < options.least_vertices)
    throw No_device_exception("a mesh of " + std::to_string(n) +
                              " vertices is too small for a device: at least " +
                              std::to_string(options.least_vertices) + " are required");
  return make_cuda_solver(mesh, options);
}

} // namespace device

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PASSES_ON_DEVICE_H
