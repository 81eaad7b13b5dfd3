// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DEVICE_START_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DEVICE_START_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Device_options.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/make_cuda_solver.h>

#include <cstddef>
#include <future>
#include <system_error>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// For most tags there is no device to start.
template <typename ConcurrencyTag> struct Device_start
{
  Device_start(const Device_options&, std::size_t) {}
};

/// Has a thread start the device, which takes a process some tenths of a second the first time,
/// while the mesh is prepared; waited for in the end. What fails is for the solver to tell.
class Concurrent_device_start
{
public:
  explicit Concurrent_device_start(Device_options options) {
    try {
      if(options.device < 0) // that of this thread, not of the other
        options.device = device::current_cuda_device();
      done_ = std::async(std::launch::async, [options] {
        try {
          device::start_cuda_device(options);
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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_DEVICE_START_H
