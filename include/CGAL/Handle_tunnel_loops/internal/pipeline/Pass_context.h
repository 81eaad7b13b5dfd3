// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_PASS_CONTEXT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_PASS_CONTEXT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/backends/Backend.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What the passes have in common: where fields come from, and how loops are handled side by side.
struct Pass_context
{
  Execution execution; ///< watched by the progress
  const Flat_mesh& mesh;
  Backend& backend;
  Step_coefficients searching; ///< of the fields of the loop passes
  bool do_tighten;
  Progress& progress;

  /// what is found for the loops of a query, while the stage comes from one part of it to another.
  std::vector<Dual_walks> dual_walks(const Dual_loop_query& query, double from, double to) const {
    return backend.dual_walks(query, searching, [this, from, to](double part) {
      return progress.goes_on(from + part * (to - from));
    });
  }

  /// calls `f(i)` for i in [0, n), each of which is much work, until somebody wants to stop.
  template <typename Function> void for_each(std::size_t n, const Function& f) const {
    for_each_index(execution, n, f, 1);
    progress.throw_if_interrupted();
  }

  /// tightens a loop, if that is wanted; in the given number of rounds, if there is one.
  template <typename... Rounds> void tighten(Crossing_loop& loop, Rounds... rounds) const {
    if(do_tighten)
      Loop_tightening(execution, mesh).tighten(loop, rounds...);
  }
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_PASS_CONTEXT_H
