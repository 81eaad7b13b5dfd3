// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_DRAW_INSIDE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_DRAW_INSIDE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_ball.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

class Own_frame;

/// A graph each arc of which stands for a part of a surface, as a Reeb graph.
struct Graph_of_parts
{
  std::vector<Index> vertex_of_node;
  std::vector<std::array<Index, 2>> arcs; ///< between nodes of the same component
  std::vector<Index> arc_of_vertex;       ///< by vertex, `no_index` at hubs
};

/// Such a graph, drawn inside.
struct Inner_drawing
{
  std::vector<Inner_ball> nodes;              ///< where they are
  std::vector<std::vector<Inner_ball>> lines; ///< by arc, from node to node
  std::vector<std::vector<char>> is_inside;   ///< by arc and edge, whether it is strictly inside
  bool is_embedded = false;                   ///< whether no edges meet but in common ends
  std::size_t number_of_balls = 0;            ///< that the lines were chosen from
};

/// draws a graph. \p mesh is in its own frame; \p places are the coordinates of its vertices as the
/// caller has them, hubs included, and those of the drawing are of the same kind; \p pairs are a
/// basis of loops.
Inner_drawing draw_inside(Execution execution,
                          const Flat_mesh& mesh,
                          const Own_frame& frame,
                          const std::vector<Vector>& places,
                          const std::vector<Flat_pair>& pairs,
                          const Graph_of_parts& graph);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_DRAW_INSIDE_H
