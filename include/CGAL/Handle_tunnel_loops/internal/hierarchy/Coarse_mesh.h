// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_COARSE_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_COARSE_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_ring.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// As many vertices of the fine mesh are in a cell, about, where passes are on a coarse one.
constexpr Index vertices_of_cell = 16;

/// Loops of a mesh that are as long are long enough to be searched for on a coarse one.
inline double least_length_on_coarse_mesh(const Flat_mesh& mesh) {
  constexpr double edge_lengths = 48.;
  return edge_lengths * mean_edge_length(mesh);
}

/*!
A mesh of the same topology as a finer one, of which its vertices are the centres of cells; made by
`Coarse_mesh_builder`. Its faces are where three cells meet.

A cell is a disc, so any two ways from cell to cell are homotopic that come through the same ones in
the same order. A loop here therefore stands for one class of curves on the fine mesh, and these
for one of loops here: intersection numbers, and all that follows from them, are the same.
*/
struct Coarse_mesh
{
  const Flat_mesh* fine = nullptr; ///< of which it is the coarse one
  Flat_mesh mesh;
  std::vector<Index> centre;          ///< by vertex, that of the fine mesh
  Uninitialized_vector<Index> parent; ///< by vertex of the fine mesh, on the way to the centre
  Uninitialized_vector<Gate> gate;    ///< by place in `mesh.neighbor`, the way to the neighbour
  double stretch = 1.;                ///< of ways from centre to centre, over their distances

  /// the vertex here for the cell in which a vertex of the fine mesh is.
  Index vertex_of(Index v) const {
    while(parent[v] != no_index)
      v = parent[v];
    return static_cast<Index>(std::lower_bound(centre.begin(), centre.end(), v) - centre.begin());
  }

  /// a loop on the fine mesh, in the class of one here. It passes no hub, and is empty if it can be
  /// drawn together to a point.
  Crossing_loop lifted(const Crossing_loop& loop) const {
    const std::vector<Index> nodes = nearer_ends(mesh, loop);
    std::vector<Index> walk;
    for(std::size_t i = 0; i < nodes.size(); ++i)
      append_way(nodes[i], nodes[i + 1 == nodes.size() ? 0 : i + 1], walk);
    return loop_along(*fine, std::move(walk));
  }

  /// a loop here, in the class of one on the fine mesh: around the cells that it comes through.
  Crossing_loop projected(const Crossing_loop& loop) const {
    std::vector<Index> walk = nearer_ends(*fine, loop);
    for(Index& v : walk)
      v = vertex_of(v);
    return loop_along(mesh, std::move(walk));
  }

private:
  // Appends, at the centre of a cell, the way on the fine mesh to that of one beside it.
  void append_way(Index from, Index to, std::vector<Index>& walk) const {
    const Gate& g = gate[mesh.row_begin[from] + mesh.position(from, to)];
    const std::size_t begin = walk.size();
    for(Index v = g.from; parent[v] != no_index; v = parent[v])
      walk.push_back(v);
    std::reverse(walk.begin() + begin, walk.end());
    for(Index v = g.to; v != no_index; v = parent[v])
      walk.push_back(v);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_COARSE_MESH_H
