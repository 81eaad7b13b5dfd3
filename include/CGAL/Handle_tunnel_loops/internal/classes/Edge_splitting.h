// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_EDGE_SPLITTING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_EDGE_SPLITTING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Splits the longest edges of a mesh at their midpoints, so that the triangles fit the same surface.
Always the longest edge: no angle becomes smaller than half of what it was (Rivara).

Each new vertex takes over the corner of an end of its edge: if a corner belongs to all faces of the
mesh that an end lies on, it does to all that the midpoint lies on.
*/
class Edge_splitting
{
public:
  explicit Edge_splitting(const Flat_mesh& mesh)
      : points_(mesh.points.begin(), mesh.points.end())
      , corners_(mesh.number_of_vertices()) {
    for(Index v = 0; v < corners_.size(); ++v)
      corners_[v] = v;
    add_faces(mesh);
  }

  /// splits edges until none is longer, or until there are so many vertices.
  void split(double longest, std::size_t number_of_vertices) {
    for(Index h = 0; h < targets_.size(); ++h)
      push(h, longest);
    while(!queue_.empty() && points_.size() < number_of_vertices) {
      const auto [length, h] = queue_.top();
      queue_.pop();
      if(length == length_of(h))
        split_edge(h, longest);
    }
  }

  /// the mesh: points and rings.
  Flat_mesh mesh() const {
    Flat_mesh mesh;
    mesh.points.resize(points_.size());
    std::copy(points_.begin(), points_.end(), mesh.points.begin());
    std::vector<Index> first(points_.size(), no_index); // halfedge from a vertex
    for(Index h = 0; h < targets_.size(); ++h)
      first[source(h)] = h;
    mesh.row_begin.resize(points_.size() + 1);
    mesh.neighbor.resize(targets_.size());
    Index size = 0;
    for(Index v = 0; v < points_.size(); ++v) {
      mesh.row_begin[v] = size;
      Index h = first[v];
      do {
        mesh.neighbor[size++] = targets_[h];
        h = twins_[previous(h)];
      } while(h != first[v]);
    }
    mesh.row_begin[points_.size()] = size;
    CGAL_postcondition(size == targets_.size());
    return mesh;
  }

  /// by vertex, a corner of all faces of the first mesh on which it lies.
  const std::vector<Index>& corners() const { return corners_; }

private:
  // Halfedges 3f, 3f + 1, 3f + 2 lead around face f.
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index source(Index h) const { return targets_[previous(h)]; }

  void add_faces(const Flat_mesh& mesh) {
    std::vector<Index> halfedges(mesh.neighbor.size()); // by place in the rings
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v);
      for(Index p = 0; p < ring.size(); ++p) {
        const Index a = ring[p], b = ring[ring.next(p)];
        if(a < v || b < v)
          continue;
        halfedges[mesh.row_begin[v] + p] = static_cast<Index>(targets_.size());
        halfedges[place(mesh, a, b)] = static_cast<Index>(targets_.size() + 1);
        halfedges[place(mesh, b, v)] = static_cast<Index>(targets_.size() + 2);
        targets_.insert(targets_.end(), {a, b, v});
      }
    }
    twins_.resize(targets_.size());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index p = 0; p < mesh.ring(v).size(); ++p)
        twins_[halfedges[mesh.row_begin[v] + p]] = halfedges[place(mesh, mesh.ring(v)[p], v)];
  }

  static std::size_t place(const Flat_mesh& mesh, Index u, Index v) {
    return mesh.row_begin[u] + mesh.ring(u).position(v);
  }

  double length_of(Index h) const { return norm(points_[targets_[h]] - points_[source(h)]); }

  // One of the two halfedges stands for the edge.
  void push(Index h, double longest) {
    if(h < twins_[h] && length_of(h) > longest)
      queue_.push({length_of(h), h});
  }

  void split_edge(Index h, double longest) {
    const Index g = twins_[h], m = static_cast<Index>(points_.size());
    points_.push_back(0.5 * (points_[source(h)] + points_[targets_[h]]));
    corners_.push_back(corners_[source(h)]);
    const Index n = cut_face(h, m), k = cut_face(g, m);
    join(h, k);
    join(g, n);
    for(Index e : {h, next(h), n, g, next(g), k})
      push((std::min)(e, twins_[e]), longest);
  }

  // Face a b c with halfedge `h` from a to b becomes a m c, and m b c is added. Returns the
  // halfedge from m to b.
  Index cut_face(Index h, Index m) {
    const Index n = static_cast<Index>(targets_.size()), across = next(h);
    const Index b = targets_[h], c = targets_[across];
    targets_.insert(targets_.end(), {b, c, m});
    twins_.insert(twins_.end(), {no_index, no_index, no_index});
    targets_[h] = m;
    join(n + 1, twins_[across]);
    join(n + 2, across);
    return n;
  }

  void join(Index h, Index g) {
    twins_[h] = g;
    twins_[g] = h;
  }

  std::vector<Vector> points_;
  std::vector<Index> corners_;         // by vertex
  std::vector<Index> targets_, twins_; // by halfedge
  std::priority_queue<std::pair<double, Index>> queue_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_EDGE_SPLITTING_H
