// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_TUNING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_TUNING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/phase_field.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// How a device is used, for benchmarks and tests to vary: no answer depends on it.
struct Tuning
{
  bool repeats_in_graph = false; ///< the steps, instead of one kernel with barriers
  int threads_per_block = 256;   ///< at most as many
  int blocks_per_multiprocessor = 4; ///< of those that meet at barriers; at most as many
  Time steps_per_run = 512; ///< of a sweep, between two looks at the callback and at the band
  Time steps_per_look = 16; ///< of the loop passes, between two looks at the meetings
  bool times_kernels = false; ///< see `Costs::kernels`; waits for each of them
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_TUNING_H
