// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What the loop passes look for: for each of several loops walks that cross it once, see
/// `Bidirectional_front`.
struct Dual_loop_query
{
  const std::vector<Crossing_loop>& loops;
  const Crossing_index& index;                  ///< of these loops
  bool bars_only_own;                           ///< `Only_loop`, or `Loops_from`
  std::vector<Index> numbers;                   ///< of the loops to search for
  Index number_of_walks = 1;                    ///< so many are enough
  std::vector<Time> numbers_of_steps{};         ///< by loop, the most to make; or empty
  std::uint64_t number_of_updates = UINT64_MAX; ///< the most to make for each
};

/// What they find for one loop.
struct Dual_walks
{
  std::vector<std::vector<Index>> walks; ///< closed, on the edges
  bool has_given_up = false;             ///< for it needed more updates
};

/// is told how far the work has come, in [0, 1], and says whether to go on.
using Callback = std::function<bool(double)>;

/*!
Computes the fields of the passes on one mesh, and what is read off them where they are: in the
memory of the processor or of a device. All that leaves it are arrays of times, and loops.

Models: `Host_backend`, `device::Device_solver`, and `Fallback_backend` for whichever is there. They
give the same answers to the last bit. Each call throws `Interrupted_exception` when its callback
says so.
*/
class Backend
{
public:
  virtual ~Backend() = default;

  /// the field of the initial pass: what its saddles offer as handles, in their order.
  ///
  /// \param seeds the vertices to start from, one in each component
  /// \param callback is called by the calling thread
  virtual std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                                      const Step_coefficients& k,
                                                      const Callback& callback) = 0;

  /// the arrival times of the last initial field.
  virtual std::vector<Time> arrival_times() = 0;

  /// the layers of the last initial field, and what happened to its fronts.
  virtual Front_log front_log() = 0;

  /// the arrival times of one field from both sides of all loops, none of which it crosses.
  virtual std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                             const Crossing_index& index,
                                             const Step_coefficients& k) = 0;

  /// the arrival times of one field from vertices, the same one more than once or not: these first,
  /// their neighbours next; `never` where it does not come.
  ///
  /// \param callback is called by the calling thread
  virtual std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                                const Step_coefficients& k,
                                                const Callback& callback) = 0;

  /// the fields of the loop passes: what is found for each of the numbers of the query.
  ///
  /// \param callback may be called by several threads at a time
  virtual std::vector<Dual_walks> dual_walks(const Dual_loop_query& query,
                                             const Step_coefficients& k,
                                             const Callback& callback) = 0;

  /// says what it is, and what it took.
  virtual void report(Statistics& statistics) const = 0;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BACKEND_H
