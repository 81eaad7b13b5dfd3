// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_HALFEDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_HALFEDGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

/// The halfedges of a flat mesh by number: that from v to the i-th neighbour in its ring is number
/// `row_begin[v] + i`.
class Flat_halfedges
{
public:
  Flat_halfedges(Execution execution, const Flat_mesh& mesh)
      : mesh_(mesh)
      , source_(mesh.neighbor.size())
      , twin_(mesh.neighbor.size())
      , face_(mesh.neighbor.size()) {
    for_each_index(execution, mesh.number_of_vertices(), [&](std::size_t v) {
      for(Index h = mesh.row_begin[v]; h < mesh.row_begin[v + 1]; ++h)
        source_[h] = static_cast<Index>(v);
    });
    find_twins();
    number_faces();
  }

  std::size_t size() const { return source_.size(); }
  Index source(Index h) const { return source_[h]; }
  Index target(Index h) const { return mesh_.neighbor[h]; }
  Index twin(Index h) const { return twin_[h]; }
  /// the face to the left.
  Index face(Index h) const { return face_[h]; }

  /// the halfedges that leave v are those from `begin(v)` to `end(v)`, counterclockwise.
  Index begin(Index v) const { return mesh_.row_begin[v]; }
  Index end(Index v) const { return mesh_.row_begin[v + 1]; }

  /// the next halfedge around the source, counterclockwise; and clockwise.
  Index after(Index h) const { return h + 1 == end(source_[h]) ? begin(source_[h]) : h + 1; }
  Index before(Index h) const { return (h == begin(source_[h]) ? end(source_[h]) : h) - 1; }

  /// the next halfedge of the face to the left.
  Index next(Index h) const { return before(twin_[h]); }

  /// the halfedge from u to v; there must be one.
  Index between(Index u, Index v) const {
    if(end(v) - begin(v) < end(u) - begin(u))
      return twin_[between(v, u)];
    return begin(u) + mesh_.ring(u).position(v);
  }

private:
  // The halfedges that lead to each vertex, sorted by where they come from, are the twins of those
  // that leave it, sorted by where they lead: two transpositions, no search in rings.
  void find_twins() {
    Uninitialized_vector<Index> arriving(size()), leaving(size());
    Uninitialized_vector<Index> place(mesh_.row_begin);
    for(Index h = 0; h < size(); ++h)
      arriving[place[target(h)]++] = h;
    place = mesh_.row_begin;
    for(std::size_t i = 0; i < size(); ++i)
      leaving[place[source_[arriving[i]]]++] = arriving[i];
    for(std::size_t i = 0; i < size(); ++i)
      twin_[leaving[i]] = arriving[i];
  }

  void number_faces() {
    Index number = 0;
    for(Index h = 0; h < size(); ++h) {
      const Index second = next(h), third = next(second);
      if(h < second && h < third) {
        face_[h] = face_[second] = face_[third] = number;
        ++number;
      }
    }
  }

  const Flat_mesh& mesh_;
  Uninitialized_vector<Index> source_, twin_, face_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_HALFEDGES_H
