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

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// How a device is used, for benchmarks and tests to vary: no answer depends on it.
struct Tuning
{
  int threads_at_barrier = 640;    ///< of each multiprocessor, at most, in kernels of many steps
  Time steps_per_run = 512;        ///< of an initial pass, between two looks at callback and band
  Time steps_per_look = 64;        ///< of the loop passes, at most, between two looks; no more than
                                   ///< `Step_coefficients::patience`
  Time steps_per_look_if_met = 16; ///< at least, where fronts have met
  bool times_kernels = false;      ///< see `Costs::kernels`; waits for each of them
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_TUNING_H
