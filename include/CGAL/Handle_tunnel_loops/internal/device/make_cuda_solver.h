// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_MAKE_CUDA_SOLVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_MAKE_CUDA_SOLVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Tuning.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <memory>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// brings a mesh, which must outlive the solver, to a device. Defined in the library
/// `Handle_tunnel_loops::cuda`. Throws `No_device_exception`, `Out_of_device_memory_exception` or
/// `Device_exception`.
std::unique_ptr<Solver>
make_cuda_solver(const Flat_mesh& mesh, const Device_options& options, const Tuning& tuning = {});

/// the number of the current device of the calling thread. Throws as the above.
int current_cuda_device();

/// does what a process has to do before it uses a device for the first time. Throws as the above.
void start_cuda_device(const Device_options& options);

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_MAKE_CUDA_SOLVER_H
