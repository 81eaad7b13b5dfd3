// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CLOSED_GRAPH_TRAITS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CLOSED_GRAPH_TRAITS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

/// What `boost::graph_traits` are for a closed `FaceListGraph` whose vertices are numbers, and
/// whose halfedges stand for their faces and edges, too.
template <typename Graph> struct Closed_graph_traits
{
private:
  struct Traversal_category : boost::vertex_list_graph_tag
  {};

public:
  using vertex_descriptor = Index;
  using halfedge_descriptor = typename Graph::Halfedge;
  using face_descriptor = halfedge_descriptor;
  using edge_descriptor = halfedge_descriptor;
  using vertex_iterator = typename Graph::Vertex_iterator;
  using halfedge_iterator = typename Graph::Halfedge_iterator;
  using face_iterator = typename Graph::Face_iterator;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  using traversal_category = Traversal_category;

  static vertex_descriptor null_vertex() { return no_index; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CLOSED_GRAPH_TRAITS_H
