// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FIND_THROATS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FIND_THROATS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A throat of a flat mesh, in its unit.
struct Flat_throat
{
  Crossing_loop loop;
  double length;
  double prominence;               ///< as a part of the length
  std::vector<Index> through = {}; ///< of the vertices asked for, those a loop through which it is
  std::uint64_t class_name = 0;    ///< of `Distinct_throats`
};

/// What throats are looked for.
struct Throat_limits
{
  double least_prominence; ///< as a part of the length
  std::vector<Index> through_vertices;
};

/// finds throats, the most prominent first: see `CGAL::throats()`. \p known are loops that may
/// become throats when they are tightened.
std::vector<Flat_throat> find_flat_throats(Execution execution,
                                           const Flat_mesh& mesh,
                                           const std::vector<Crossing_loop>& known,
                                           const Throat_limits& limits);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FIND_THROATS_H
