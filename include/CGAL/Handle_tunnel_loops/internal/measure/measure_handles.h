// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_HANDLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_HANDLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A ball that passes along a closed curve.
struct Flat_ball
{
  double radius;             ///< of the largest one
  double error;              ///< how much that may be more or less
  std::vector<Vector> curve; ///< of its centre; the first point is at the throat
};

/// What balls pass inside the solid and outside, by pair.
struct Flat_measures
{
  struct Pair
  {
    std::optional<Flat_ball> inside, outside;
  };
  std::vector<Pair> pairs;
  std::string why; ///< something is missing; empty if nothing is
};

/// A handle loop and its tunnel loop, as closed polylines.
using Polyline_pair = std::array<std::vector<Vector>, 2>;

/// measures the handles of a surface: \p places are those of its vertices, hubs included, \p pairs
/// a basis of loops.
Flat_measures measure_handles(Execution execution,
                              const Flat_mesh& mesh,
                              const std::vector<Vector>& places,
                              const std::vector<Polyline_pair>& pairs);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_HANDLES_H
