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

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/fronts/Front_log.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Dual_loop_query.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Handle_candidate.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// is told how far the work has come, in [0, 1], and says whether to go on.
using Callback = std::function<bool(double)>;

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

/// The passes on a device, behind plain arrays. All that is written to the host are loops.
class Solver
{
public:
  virtual ~Solver() = default;

  /// the initial pass: the handles of the sweep from the given sources, in their order.
  virtual std::vector<Handle_candidate>
  sweep(const std::vector<Index>& seeds, const Step_coefficients& k, const Callback& callback) = 0;

  /// the arrival times of the last sweep.
  virtual std::vector<Time> arrival_times() = 0;

  /// the layers of the last sweep, and what happened to its fronts.
  virtual Front_log front_log() = 0;

  /// the arrival times of one field from both sides of all loops, none of which it crosses.
  virtual std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                             const Crossing_index& index,
                                             const Step_coefficients& k) = 0;

  /// the loop passes: what is found for each of the numbers.
  virtual std::vector<Dual_walks>
  search(const Dual_loop_query& search, const Step_coefficients& k, const Callback& callback) = 0;

  virtual Costs costs() const = 0;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H
