// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_REEB_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Function_on_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A Reeb graph that is ready to be handed out.
struct Found_reeb_graph
{
  Embedded_reeb_graph graph;
  /// by hub, a vertex on its curve, at which is said to be what is at the hub.
  std::vector<Index> vertices_of_hubs;
};

/// sweeps a function and finishes its Reeb graph.
Found_reeb_graph find_reeb_graph(Execution execution,
                                 const Flat_mesh& mesh,
                                 const Function_on_vertices& function,
                                 Reeb_measure default_measure,
                                 const Reeb_options& options,
                                 Reeb_statistics& statistics);

/// throws `std::invalid_argument` unless the options make sense.
void check(const Reeb_options& options);

/// the indices in the arrays of vertices with these indices of the caller. Throws
/// `std::invalid_argument` if one has no faces.
std::vector<Index> places_of_sources(const Flat_mesh& mesh,
                                     const std::vector<std::size_t>& sources);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_REEB_GRAPH_H
