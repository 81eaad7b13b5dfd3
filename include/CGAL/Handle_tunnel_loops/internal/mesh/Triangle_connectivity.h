// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_TRIANGLE_CONNECTIVITY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_TRIANGLE_CONNECTIVITY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The halfedges of an oriented 2-manifold of triangles by number: 3 f + i goes from corner i of
/// face f to the next one; those without a face come after them.
class Triangle_connectivity
{
public:
  Triangle_connectivity() = default;

  /// \p corners are those of one face after the other, each less than the number of vertices.
  /// Throws `Invalid_mesh_exception`. Near linear in the size of the mesh.
  Triangle_connectivity(Execution execution,
                        std::size_t number_of_vertices,
                        Uninitialized_vector<Index> corners);

  std::size_t number_of_vertices() const { return arriving_.size(); }
  std::size_t number_of_faces() const { return number_of_corners_ / 3; }
  std::size_t number_of_halfedges() const { return source_.size(); }

  bool is_border(Index h) const { return h >= number_of_corners_; }
  Index opposite(Index h) const { return opposite_[h]; }
  Index source(Index h) const { return source_[h]; }
  Index target(Index h) const { return source_[next(h)]; }

  Index next(Index h) const {
    return is_border(h) ? next_of_border_[h - number_of_corners_] : next_in_face(h);
  }
  Index previous(Index h) const {
    return is_border(h) ? arriving_[source_[h]] : next_in_face(next_in_face(h));
  }

  /// a halfedge to a vertex: the one without a face, if there is one, or else that of the last
  /// face; `no_index` if there is none.
  Index arriving(Index v) const { return arriving_[v]; }

  /// the halfedge from u to v, `no_index` if there is none.
  Index between(Index u, Index v) const {
    const Index first = arriving_[v];
    for(Index h = first; h != no_index;) {
      if(source_[h] == u)
        return h;
      h = opposite_[next(h)];
      if(h == first)
        break;
    }
    return no_index;
  }

private:
  // A halfedge in either direction, with the larger one of its vertices.
  struct Entry
  {
    Index far_vertex, halfedge;
  };
  using Entries = Uninitialized_vector<Entry>;
  using Edge = Span<const Entry>; // all halfedges between two vertices

  static Index next_in_face(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }

  void check_corners(Execution execution) const;
  void find_opposites(Execution execution);
  Entries sort_by_near_vertex(Execution execution, Uninitialized_vector<Index>& end) const;
  bool is_edge(Edge edge) const;
  [[noreturn]] void throw_defect(Index near_vertex, Edge edge) const;
  void find_arriving();
  void add_borders(const std::vector<Index>& inner);
  void check_fans(Execution execution) const;
  Index size_of_fan(Index v) const;
  [[noreturn]] static void throw_fan_defect(Index v);

  std::size_t number_of_corners_ = 0;
  Uninitialized_vector<Index> source_;   // first the corners
  Uninitialized_vector<Index> opposite_; // by halfedge
  Uninitialized_vector<Index> arriving_; // by vertex
  std::vector<Index> next_of_border_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_TRIANGLE_CONNECTIVITY_H
