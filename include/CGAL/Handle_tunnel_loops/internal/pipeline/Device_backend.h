// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DEVICE_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DEVICE_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/make_cuda_solver.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Whether the program is linked with the library for CUDA devices. It depends on a type, so that
/// nobody is asked who does not use it.
template <typename>
struct Is_linked_with_cuda
#ifdef CGAL_LINKED_WITH_CUDA
    : std::true_type
#else
    : std::false_type
#endif
{};

/// The fields of the passes, on a device; what becomes of the loops, on the processor.
template <typename Execution> class Device_backend
{
public:
  Device_backend(const Flat_mesh& mesh,
                 const Step_coefficients& k,
                 const Device_options& options,
                 const device::Tuning& tuning = {})
      : solver_(device::make_cuda_solver(mesh, options, tuning))
      , coefficients_(k)
      , coefficients_for_searching_(internal::coefficients_for_searching(k)) {
    static_assert(Is_linked_with_cuda<Execution>::value,
                  "Cuda_tag is used but the program is not linked with Handle_tunnel_loops::cuda");
  }

  device::Costs costs() const { return solver_->costs(); }

  void report(Statistics& statistics) const {
    statistics.backend = "cuda";
    statistics.device_bytes = costs().largest_bytes;
  }

  std::vector<Handle_candidate> sweep(const std::vector<Index>& seeds, Progress& progress) {
    times_.clear();
    return solver_->sweep(seeds, coefficients_, callback_of(progress));
  }

  /// Only a loop for which nothing else is found asks for them.
  const std::vector<Time>& arrival_times() {
    if(times_.empty())
      times_ = solver_->arrival_times();
    return times_;
  }

  Front_log front_log() { return solver_->front_log(); }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index) {
    return solver_->times_from_loops(loops, index, coefficients_for_searching_);
  }

  template <typename Function>
  void search(const Dual_loop_query& search, Progress& progress, const Function& f) {
    hand_out(search, found_walks(search, progress), progress, f);
  }

  /// the first half of `search()`: all that the device is needed for.
  std::vector<Dual_walks> found_walks(const Dual_loop_query& search, Progress& progress) {
    return solver_->search(search, coefficients_for_searching_, [&](double) {
      progress.throw_if_interrupted();
      return true;
    });
  }

  /// the second half of `search()`.
  template <typename Function>
  static void hand_out(const Dual_loop_query& search,
                       const std::vector<Dual_walks>& found,
                       Progress& progress,
                       const Function& f) {
    for_each_index(
        Execution(), found.size(),
        [&](std::size_t i) {
          if(!progress.is_interrupted())
            f(search.numbers[i], found[i]);
        },
        1);
    progress.throw_if_interrupted();
  }

private:
  static device::Callback callback_of(Progress& progress) {
    return [&progress](double part) {
      progress.advance(part);
      return true;
    };
  }

  std::unique_ptr<device::Solver> solver_;
  Step_coefficients coefficients_, coefficients_for_searching_;
  std::vector<Time> times_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DEVICE_BACKEND_H
