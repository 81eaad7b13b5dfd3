// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PART_OF_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PART_OF_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
The faces near a closed walk as a mesh of their own: those at the walk, and two rings around these.
It may be changed as far as the faces at the walk go: there, and around their vertices, all is as in
the whole mesh. At its end, faces have no twins.
*/
class Part_of_mesh
{
public:
  Part_of_mesh(const Surgery_mesh& whole, const Closed_walk& walk)
      : vertices_(walk) {
    make_set(vertices_);
    for(int ring = 0; ring < 3; ++ring)
      widen(whole);
    std::vector<Surgery_mesh::Point> points;
    for(Index v : vertices_)
      points.push_back(whole.point(v));
    std::vector<Surgery_mesh::Face> corners;
    std::vector<Index> twins;
    for(Index f : faces_) {
      corners.push_back(whole.corners(f));
      for(Index& v : corners.back())
        v = vertex_of_part(v);
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        twins.push_back(halfedge_of_part(whole.twin(h)));
    }
    mesh_ = Surgery_mesh(std::move(points), std::move(corners), std::move(twins));
    const auto number_below = [this](Index v) {
      return static_cast<Index>(std::lower_bound(vertices_.begin(), vertices_.end(), v) -
                                vertices_.begin());
    };
    const Index first_hub = number_below(whole.first_hub());
    mesh_.set_hubs(first_hub, number_below(whole.first_hub() + whole.number_of_hubs()) - first_hub);
  }

  Surgery_mesh& mesh() { return mesh_; }
  const Surgery_mesh& mesh() const { return mesh_; }

  // ---- what is of the whole mesh

  Index vertex_bound() const { return static_cast<Index>(vertices_.size()); }
  Index face_bound() const { return static_cast<Index>(faces_.size()); }
  Index vertex(Index v) const { return vertices_[v]; }
  Index face(Index f) const { return faces_[f]; }

  Closed_walk walk_of_part(Closed_walk walk) const {
    for(Index& v : walk)
      v = vertex_of_part(v);
    return walk;
  }

private:
  static Index position(Index i, const std::vector<Index>& set) {
    const auto it = std::lower_bound(set.begin(), set.end(), i);
    return it != set.end() && *it == i ? static_cast<Index>(it - set.begin()) : no_index;
  }

  Index vertex_of_part(Index v) const { return position(v, vertices_); }

  Index halfedge_of_part(Index h) const {
    const Index f = position(Surgery_mesh::face(h), faces_);
    return f == no_index ? no_index : 3 * f + h % 3;
  }

  void widen(const Surgery_mesh& whole) {
    for(Index v : vertices_)
      whole.for_each_outgoing(v, [&](Index h) { faces_.push_back(Surgery_mesh::face(h)); });
    make_set(faces_);
    vertices_ = vertices_of(whole, faces_);
  }

  std::vector<Index> vertices_, faces_; // of the whole mesh, in ascending order
  Surgery_mesh mesh_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PART_OF_MESH_H
