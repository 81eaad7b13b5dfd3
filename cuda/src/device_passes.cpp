// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/device/device_passes.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Passes_on_device.h>

#include <algorithm>
#include <system_error>

namespace CGAL::Handle_tunnel_loops::internal::device {

std::future<void> start_device(Device_options options) {
  try {
    if(options.device < 0) // that of this thread, not of the other
      options.device = current_cuda_device();
    return std::async(std::launch::async, [options] {
      try {
        start_cuda_device(options);
      } catch(const Device_exception&) {
      }
    });
  } catch(const Device_exception&) {
  } catch(const std::system_error&) { // there is no thread to be had
  }
  return {};
}

std::future<void> start_device_if_worth_it(const Device_options& options,
                                           std::size_t number_of_vertices,
                                           bool is_coarse) {
  return number_of_vertices / (is_coarse ? vertices_of_cell : 1) < options.least_vertices
             ? std::future<void>()
             : start_device(options);
}

std::shared_ptr<Passes>
device_passes(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
  return std::make_shared<Field_passes<Solver>>(
      execution_of<Threads_if_available_tag>(), mesh, std::move(seeds), options,
      [&mesh, where = options.device] { return make_cuda_solver(mesh, where); },
      least_vertices_for_cells);
}

std::shared_ptr<Passes> device_passes_if_worth_it(const Flat_mesh& mesh,
                                                  std::vector<Index> seeds,
                                                  const Pass_options& options) {
  const Execution execution = execution_of<Threads_if_available_tag>();
  return std::make_shared<Field_passes<Fallback_backend>>(
      execution, mesh, std::move(seeds), options,
      [execution, &mesh, where = options.device] {
        return std::make_unique<Fallback_backend>(execution, mesh,
                                                  [&] { return solver_if_worth_it(mesh, where); });
      },
      // It is started for the fields, which are on a coarse mesh.
      (std::max)(least_vertices_for_cells, vertices_of_cell * options.device.least_vertices));
}

} // namespace CGAL::Handle_tunnel_loops::internal::device
