// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_START_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_START_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/make_cuda_solver.h>

#include <future>
#include <system_error>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

namespace device {

/// Has a thread start the device, which takes a process some tenths of a second the first time,
/// while the mesh is prepared; waited for in the end. What fails is for the solver to tell.
class Device_start
{
public:
  explicit Device_start(Device_options options) {
    try {
      if(options.device < 0) // that of this thread, not of the other
        options.device = current_cuda_device();
      done_ = std::async(std::launch::async, [options] {
        try {
          start_cuda_device(options);
        } catch(const Device_exception&) {
        }
      });
    } catch(const Device_exception&) {
    } catch(const std::system_error&) { // there is no thread to be had
    }
  }

private:
  std::future<void> done_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_START_H
