// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_FIRST_CELLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_FIRST_CELLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_ring.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What somebody else found around a cell.
struct Cell_look
{
  double point[3];           ///< its centre of mass, if it is fit
  Index number_of_neighbors; ///< none if it is not fit, `no_index` if that was left open
  Index first;               ///< of its neighbours, among those of all
};

/// The first cells of a mesh, for somebody else to find (see `device::Solver`): what is asked for,
/// and room for the answer, which is that of `Coarse_mesh_builder` to the last bit.
struct First_cells
{
  /// Room for so many neighbours of each cell there is: a mesh has no more, but for its handles.
  static constexpr std::size_t neighbors_of_cell = 7;

  Index spacing;
  const std::vector<Index>& seeds;
  Index first_hub, number_of_hubs;

  Span<Cell_link> links;   ///< by vertex
  Span<char> are_vertices; ///< by vertex

  /// reads the centres off the links, which are there, and makes room for what is around them.
  std::function<void(First_cells&)> find_centres;

  bool are_begun = false;                     ///< whether anything has been put down
  std::vector<Index> centres = {};            ///< sorted
  Uninitialized_vector<Cell_look> looks = {}; ///< by centre
  Uninitialized_vector<Cell_neighbor> neighbors = {};
};

/// finds them, or says that it does not.
using Find_first_cells = std::function<bool(First_cells&)>;

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_FIRST_CELLS_H
