// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CEILINGS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CEILINGS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// What a device can do at most, measured; for benchmarks. Defined in the library
/// `Handle_tunnel_loops::cuda`.
struct Ceilings
{
  std::string device;    ///< its name
  std::string versions;  ///< of the driver and of the runtime
  double seconds_to_map; ///< so many bytes of its memory, if the process keeps none of it
  std::size_t mapped_bytes;
  double bytes_per_second;   ///< of a copy within its memory, read and written
  double seconds_per_launch; ///< of kernels that do nothing, one after the other
  double seconds_per_step;   ///< of a barrier of the grid that the passes use
};

/// measures the given device, or the current one if the number is negative.
Ceilings measure_ceilings(int device);

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CEILINGS_H
