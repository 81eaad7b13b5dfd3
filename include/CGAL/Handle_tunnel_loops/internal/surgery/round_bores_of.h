// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ROUND_BORES_OF_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ROUND_BORES_OF_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loop_choice.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A bore in the caller's unit.
struct Bore_of_caller
{
  double diameter;
  Vector center, axis;
  double length, deviation;
  std::size_t drilling;
};

/// A tunnel loop, with the points of its places as they are.
struct Tunnel_to_search
{
  std::vector<Place_on_edge> places;
  std::vector<Vector> points;
};

/// by tunnel loop, the round bore that it goes around, if there is one.
std::vector<std::optional<Bore_of_caller>>
round_bores_of(Execution execution,
               const Triangle_list& triangles,
               const std::vector<Tunnel_to_search>& tunnels);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_ROUND_BORES_OF_H
