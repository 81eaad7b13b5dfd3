// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_EMBEDDED_REEB_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_EMBEDDED_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

using Polyline = std::vector<Vector>;

inline double length(const Polyline& line) {
  double sum = 0.;
  for(std::size_t i = 1; i < line.size(); ++i)
    sum += norm(line[i] - line[i - 1]);
  return sum;
}

/// A Reeb graph as it is handed out, still in the terms of the flat mesh.
struct Embedded_reeb_graph
{
  struct Arc
  {
    Index lower, upper;          ///< nodes
    Polyline line;               ///< from the lower node to the upper one
    std::vector<Index> vertices; ///< of the mesh, in the order of the sweep
  };

  std::vector<Flat_reeb_graph::Node> nodes;
  std::vector<Arc> arcs;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_EMBEDDED_REEB_GRAPH_H
