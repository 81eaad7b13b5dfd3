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

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Marks of the faces and vertices of a mesh, which are none: who makes some takes them away.
struct Face_marks
{
  explicit Face_marks(const Surgery_mesh& mesh)
      : is_there(mesh.face_bound(), 0)
      , is_beyond(mesh.face_bound(), 0)
      , number_at(mesh.vertex_bound(), 0) {}

  std::vector<char> is_there, is_beyond; ///< by face
  std::vector<Index> number_at;          ///< by vertex
};

/// Some faces, and where their border is, that grow by rings around them and by what makes their
/// border touch itself, and may become fewer again. Each step takes as long as it adds faces.
class Growing_faces
{
public:
  /// the faces at some vertices. There are marks as long as they live.
  Growing_faces(const Surgery_mesh& mesh, Face_marks& marks, const std::vector<Index>& vertices)
      : mesh_(mesh)
      , marks_(marks) {
    add_faces_at(vertices);
  }
  Growing_faces(const Growing_faces&) = delete;
  Growing_faces& operator=(const Growing_faces&) = delete;
  ~Growing_faces() { return_to({0, {}, {}}); }

  /// in the order in which they came.
  const std::vector<Index>& faces() const { return faces_; }

  std::size_t size() const { return faces_.size(); }

  bool contains(Index face) const { return marks_.is_there[face]; }

  /// marks of faces that are not contained, for any use.
  std::vector<char>& marks_beyond() const { return marks_.is_beyond; }

  void add(Index face) {
    if(contains(face))
      return;
    marks_.is_there[face] = 1;
    faces_.push_back(face);
    for(Index h : {3 * face, 3 * face + 1, 3 * face + 2}) {
      count_side(h, 1);
      since_ring_.push_back(mesh_.source(h));
      since_pinches_.push_back(mesh_.source(h));
    }
  }

  /// What there was at some time.
  struct Stage
  {
    std::size_t size;
    std::vector<Index> since_ring, since_pinches;
  };

  Stage stage() const { return {size(), since_ring_, since_pinches_}; }

  /// takes away what has come since.
  void return_to(Stage stage) {
    for(; size() > stage.size; faces_.pop_back()) {
      const Index face = faces_.back();
      for(Index h : {3 * face, 3 * face + 1, 3 * face + 2})
        count_side(h, -1);
      marks_.is_there[face] = 0;
    }
    since_ring_ = std::move(stage.since_ring);
    since_pinches_ = std::move(stage.since_pinches);
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
  // A halfedge of a face that comes, by 1, or goes, by -1, is on the border, or has its twin there
  // no longer.
  void count_side(Index h, int sign) {
    const Index twin = mesh_.twin(h);
    if(!contains(mesh_.face(twin)))
      marks_.number_at[mesh_.source(h)] += static_cast<Index>(sign);
    else
      marks_.number_at[mesh_.source(twin)] -= static_cast<Index>(sign);
  }

  void add_faces_at(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      mesh_.for_each_outgoing(v, [this](Index h) { add(mesh_.face(h)); });
  }

  // Of vertices, each once, those where at least so many halfedges of the border begin.
  std::vector<Index> taken(std::vector<Index>& vertices, Index least) {
    std::vector<Index> all = std::exchange(vertices, {});
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](Index v) { return marks_.number_at[v] < least; }),
              all.end());
    make_set(all);
    return all;
  }

  const Surgery_mesh& mesh_;
  Face_marks& marks_; // and how many halfedges of the border begin at each vertex
  std::vector<Index> faces_;
  // Vertices of faces that have come since: all others of the border were taken, and lie within.
  std::vector<Index> since_ring_, since_pinches_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_GROWING_FACES_H
