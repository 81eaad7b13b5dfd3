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
#include <CGAL/Handle_tunnel_loops/internal/backends/Fallback_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Device_start.h>
#include <CGAL/Handle_tunnel_loops/internal/device/make_cuda_solver.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Field_passes.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

namespace device {

/// The passes with fields on a CUDA device; see `Passes_of_tag`.
struct Passes_on_device
{
  struct Head_start : Device_start
  {
    Head_start(const Device_options& options, std::size_t)
        : Device_start(options) {}
  };

  static std::unique_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return std::make_unique<Field_passes>(
        execution_of<Parallel_if_available_tag>(), mesh, std::move(seeds), options,
        [&mesh, where = options.device] { return make_cuda_solver(mesh, where); });
  }
};

/// The same where there is a device and the mesh is worth starting it.
struct Passes_if_there_is_a_device
{
  struct Head_start
  {
    Head_start(const Device_options& options, std::size_t number_of_vertices) {
      if(number_of_vertices >= options.least_vertices)
        start_.emplace(options);
    }

  private:
    std::optional<Device_start> start_;
  };

  static std::unique_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    const Execution execution = execution_of<Parallel_if_available_tag>();
    return std::make_unique<Field_passes>(
        execution, mesh, std::move(seeds), options,
        [execution, &mesh, where = options.device] { return backend(execution, mesh, where); });
  }

private:
  static std::unique_ptr<Backend>
  backend(Execution execution, const Flat_mesh& mesh, const Device_options& options) {
    const std::size_t n = mesh.number_of_vertices();
    if(n < options.least_vertices)
      return std::make_unique<Host_backend>(execution, mesh,
                                            "a mesh of " + std::to_string(n) +
                                                " vertices does not pay for a device, but " +
                                                std::to_string(options.least_vertices) + " do");
    return std::make_unique<Fallback_backend>(execution, mesh,
                                              [&] { return make_cuda_solver(mesh, options); });
  }
};

} // namespace device

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_PASSES_ON_DEVICE_H
