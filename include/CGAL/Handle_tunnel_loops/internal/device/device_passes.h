// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>

#include <cstddef>
#include <future>
#include <memory>
#include <utility>
#include <vector>

// What programs use of `Handle_tunnel_loops::cuda`, where it is compiled.
namespace CGAL::Handle_tunnel_loops::internal::device {

/// has a thread start the device, which takes a process some tenths of a second the first time.
/// What fails is for the solver to tell.
std::future<void> start_device(Device_options options);

/// the same if a mesh of so many vertices is worth it.
std::future<void> start_device_if_worth_it(const Device_options& options,
                                           std::size_t number_of_vertices,
                                           bool is_coarse);

/// the passes with fields on a device.
std::shared_ptr<Passes>
device_passes(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options);

/// the same where there is a device and the mesh is worth starting it, else on the processor.
std::shared_ptr<Passes> device_passes_if_worth_it(const Flat_mesh& mesh,
                                                  std::vector<Index> seeds,
                                                  const Pass_options& options);

/// See `Passes_of_tag`.
struct Passes_on_device
{
  static constexpr bool may_coarsen = true;

  static std::future<void> head_start(const Device_options& options, std::size_t, bool) {
    return start_device(options);
  }

  static std::shared_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return device_passes(mesh, std::move(seeds), options);
  }
};

struct Passes_if_there_is_a_device
{
  static constexpr bool may_coarsen = true;

  static std::future<void>
  head_start(const Device_options& options, std::size_t number_of_vertices, bool is_coarse) {
    return start_device_if_worth_it(options, number_of_vertices, is_coarse);
  }

  static std::shared_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return device_passes_if_worth_it(mesh, std::move(seeds), options);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_PASSES_H
