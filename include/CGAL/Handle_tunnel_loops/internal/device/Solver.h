// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/backends/Backend.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// What all launches of a kernel cost.
struct Kernel_cost
{
  std::uint64_t number_of_launches = 0;
  double seconds = 0.;
};

/// What the passes cost.
struct Costs
{
  std::uint64_t number_of_updates = 0;
  std::uint64_t number_of_steps = 0;
  double seconds_of_sweeps = 0.; ///< of the fields over the whole mesh
  std::uint64_t number_of_batches = 0;
  std::size_t largest_batch = 0;              ///< loop passes at a time
  std::size_t largest_bytes = 0;              ///< in use at one time
  std::map<std::string, Kernel_cost> kernels; ///< by the name of their type, if they were timed
};

/// A backend that says what it cost.
class Solver : public Backend
{
public:
  virtual Costs costs() const = 0;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H
