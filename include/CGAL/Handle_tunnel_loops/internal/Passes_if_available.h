// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_IF_AVAILABLE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_IF_AVAILABLE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/Device_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/Host_passes.h>

#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The fields of the passes, on a device if there is one that takes the mesh, else on the
/// processor.
template <typename Execution> class Passes_if_available
{
public:
  Passes_if_available(const Flat_mesh& mesh,
                      const Step_coefficients& k,
                      const Device_options& options) {
    try_device(mesh, k, options, Is_linked_with_cuda<Execution>());
    if(!device_)
      host_ = std::make_unique<Host_passes<Execution>>(mesh, k, options);
  }

  void report(Statistics& statistics) const {
    if(device_)
      return device_->report(statistics);
    host_->report(statistics);
    statistics.fallback = fallback_;
  }

  std::vector<Sweep_handle> sweep(const std::vector<Index>& seeds, Progress& progress) {
    return device_ ? device_->sweep(seeds, progress) : host_->sweep(seeds, progress);
  }

  const std::vector<Time>& sweep_times() {
    return device_ ? device_->sweep_times() : host_->sweep_times();
  }

  Front_log front_log() { return device_ ? device_->front_log() : host_->front_log(); }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index) {
    return device_ ? device_->times_from_loops(loops, index)
                   : host_->times_from_loops(loops, index);
  }

  template <typename Function>
  void search(const Loop_search& search, Progress& progress, const Function& f) {
    if(device_)
      device_->search(search, progress, f);
    else
      host_->search(search, progress, f);
  }

private:
  void try_device(const Flat_mesh& mesh,
                  const Step_coefficients& k,
                  const Device_options& options,
                  std::true_type) {
    try {
      device_ = std::make_unique<Device_passes<Execution>>(mesh, k, options);
    } catch(const Device_exception& e) {
      fallback_ = e.what();
    }
  }

  void
  try_device(const Flat_mesh&, const Step_coefficients&, const Device_options&, std::false_type) {
    fallback_ = "the program is not linked with Handle_tunnel_loops::cuda";
  }

  std::unique_ptr<Device_passes<Execution>> device_;
  std::unique_ptr<Host_passes<Execution>> host_;
  std::string fallback_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_IF_AVAILABLE_H
