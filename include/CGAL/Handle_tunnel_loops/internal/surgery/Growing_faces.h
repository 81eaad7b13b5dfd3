// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_GROWING_FACES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_GROWING_FACES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index_table.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Some faces, and where their border is, that grow by rings around them and by what makes their
/// border touch itself. Each step takes as long as it adds faces; and they need not be near each
/// other by their numbers.
class Growing_faces
{
public:
  /// the faces at some vertices.
  Growing_faces(const Surgery_mesh& mesh, const std::vector<Index>& vertices)
      : mesh_(&mesh) {
    add_faces_at(vertices);
  }

  /// in the order in which they came.
  const std::vector<Index>& faces() const { return faces_; }

  std::size_t size() const { return faces_.size(); }

  bool contains(Index face) const { return is_there_.find(face) != nullptr; }

  void add(Index face) {
    if(!is_there_.insert(face, 1).second)
      return;
    faces_.push_back(face);
    for(Index h : {3 * face, 3 * face + 1, 3 * face + 2}) {
      const Index twin = mesh_->twin(h);
      Index& number = number_at(mesh_->source(h)); // which makes a place for each vertex
      if(!contains(mesh_->face(twin)))
        ++number;
      else
        --number_at(mesh_->source(twin));
      since_ring_.push_back(mesh_->source(h));
      since_pinches_.push_back(mesh_->source(h));
    }
  }

  /// a ring around the faces, which holds all that come to their border.
  void add_ring() { add_faces_at(taken(since_ring_, 1)); }

  /// the faces at vertices where the border touches itself. Returns whether there are such.
  bool add_faces_at_pinches() {
    const std::vector<Index> vertices = taken(since_pinches_, 2);
    add_faces_at(vertices);
    return !vertices.empty();
  }

private:
  // How many halfedges of the border begin at a vertex of the faces.
  Index& number_at(Index v) { return *number_at_.insert(v, 0).first; }

  void add_faces_at(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      mesh_->for_each_outgoing(v, [this](Index h) { add(mesh_->face(h)); });
  }

  // Of vertices, each once, those where at least so many halfedges of the border begin.
  std::vector<Index> taken(std::vector<Index>& vertices, Index least) {
    std::vector<Index> all = std::exchange(vertices, {});
    all.erase(std::remove_if(all.begin(), all.end(), [&](Index v) { return number_at(v) < least; }),
              all.end());
    make_set(all);
    return all;
  }

  const Surgery_mesh* mesh_;
  std::vector<Index> faces_;
  Index_table is_there_, number_at_; // by face, and by vertex
  // Vertices of faces that have come since: all others of the border were taken, and lie within.
  std::vector<Index> since_ring_, since_pinches_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_GROWING_FACES_H
