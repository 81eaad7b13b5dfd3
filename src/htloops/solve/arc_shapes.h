// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ARC_SHAPES_H
#define HTLOOPS_ARC_SHAPES_H

#include "mesh_types.h"
#include "solve/reeb_answer.h"

#include <vector>

namespace htloops {

/// How thick the surface is along the arcs of its Reeb graph, and which arcs lie on cycles.
struct Arc_shapes
{
  std::vector<double> girths; ///< by arc: how long its contour is half way, by its vertices
  /// by arc, and by point of its polyline: the mean distance of the vertices that are nearest to
  /// it; where there are none, what is between those before and after.
  std::vector<std::vector<double>> radii;
  std::vector<bool> is_on_cycle; ///< by arc: whether the graph stays connected without it
};

Arc_shapes shapes_of_arcs(const Mesh& mesh, const Reeb_answer& answer);

} // namespace htloops

#endif // HTLOOPS_ARC_SHAPES_H
