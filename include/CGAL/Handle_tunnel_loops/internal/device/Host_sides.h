// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_HOST_SIDES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_HOST_SIDES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/executors/buffers.h>
#include <CGAL/Handle_tunnel_loops/internal/kernels/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// The loops of a batch of passes, as the arrays of `Loop_sides`.
struct Host_sides
{
  std::vector<Index> loops; ///< by pass, the number of its loop
  std::vector<Time> last_steps;
  std::vector<Crossing> crossings;
  std::vector<Index> pass, begin;
  std::vector<double> along;
};

inline Host_sides
sides_of(const Flat_mesh& mesh, const Dual_loop_query& search, const std::vector<Index>& loops) {
  Host_sides sides;
  sides.loops = loops;
  sides.begin.push_back(0);
  std::vector<double> along;
  for(Index i = 0; i < loops.size(); ++i) {
    const Crossing_loop& loop = search.loops[loops[i]];
    measure_left_side(mesh, loop, along);
    sides.along.insert(sides.along.end(), along.begin(), along.end());
    sides.crossings.insert(sides.crossings.end(), loop.begin(), loop.end());
    sides.pass.insert(sides.pass.end(), loop.size(), i);
    sides.begin.push_back(static_cast<Index>(sides.crossings.size()));
    sides.last_steps.push_back(search.numbers_of_steps.empty() ? never
                                                               : search.numbers_of_steps[loops[i]]);
  }
  return sides;
}

/// The same in the memory of an executor.
template <typename Executor> class Device_sides
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  Device_sides(Executor& executor, const Host_sides& sides)
      : crossings_(uploaded(executor, sides.crossings))
      , pass_(uploaded(executor, sides.pass))
      , begin_(uploaded(executor, sides.begin))
      , along_(uploaded(executor, sides.along)) {}

  std::size_t number_of_crossings() const { return crossings_.span().size(); }

  Loop_sides view() const {
    return {crossings_.span(), pass_.span(), begin_.span(), along_.span()};
  }

private:
  Buffer<Crossing> crossings_;
  Buffer<Index> pass_, begin_;
  Buffer<double> along_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_HOST_SIDES_H
