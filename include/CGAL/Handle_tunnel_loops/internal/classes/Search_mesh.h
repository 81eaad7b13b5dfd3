// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Edge_splitting.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
A mesh to search for loops on: that of the caller, or one on the same surface with shorter edges.

Each vertex has a corner of the mesh that stands for it: of all faces of the mesh that it lies on.
So an edge of the finer mesh, which lies on a face, leads to an edge of that face or to nothing, and
a closed walk on the finer mesh to one on the edges of the mesh, in the same class.
*/
class Search_mesh
{
public:
  explicit Search_mesh(const Flat_mesh& mesh)
      : mesh_(&mesh) {}

  Search_mesh(const Search_mesh&) = delete;
  Search_mesh& operator=(const Search_mesh&) = delete;

  /// refines the mesh to one of about so many vertices where that is more, with even edges: the
  /// ways along edges are poor where triangles are long and thin.
  void refine(std::size_t number_of_vertices) {
    const std::size_t n = (std::max)(number_of_vertices, mesh_->number_of_vertices());
    // An even mesh of n vertices has 2n triangles of area s^2 sqrt(3) / 4.
    const double longest = std::sqrt(1.5 * 2.31 * area() / double(2 * n));
    Edge_splitting splitting(*mesh_);
    splitting.split(longest, 2 * n);
    if(splitting.corners().size() == mesh_->number_of_vertices())
      return;
    finer_ = splitting.mesh();
    corners_ = splitting.corners();
    find_steps();
    mesh_ = &finer_;
  }

  /// computes the lengths of all edges once: it pays if many searches follow.
  void measure() {
    lengths_.resize(mesh_->neighbor.size());
    for(Index v = 0; v < number_of_vertices(); ++v)
      for(Index p = 0; p < ring(v).size(); ++p)
        lengths_[mesh_->row_begin[v] + p] = static_cast<float>(mesh_->edge_length(v, ring(v)[p]));
  }

  std::size_t number_of_vertices() const { return mesh_->number_of_vertices(); }
  const Vector& point(Index v) const { return mesh_->points[v]; }
  Ring ring(Index v) const { return mesh_->ring(v); }

  /// the length of the edge to the neighbour in a position of the ring.
  float edge_length(Index v, Index position) const {
    return lengths_.empty() ? static_cast<float>(mesh_->edge_length(v, ring(v)[position]))
                            : lengths_[mesh_->row_begin[v] + position];
  }

  /// the corner of the mesh that stands for a vertex.
  Index corner(Index v) const { return corners_.empty() ? v : corners_[v]; }

  /// of the edge to the neighbour in a position of the ring: the position of the neighbour's corner
  /// in the ring of the corner of `v`, `no_index` if it is the same corner.
  Index step(Index v, Index position) const {
    return corners_.empty() ? position : steps_[mesh_->row_begin[v] + position];
  }

  /// a vertex near a place, by steps towards it from a corner near it.
  Index vertex_near(const Vector& place, Index corner) const {
    Index v = corner;
    for(double best = squared_distance(v, place);;) {
      const Index from = v;
      for(Index u : ring(from))
        if(const double d = squared_distance(u, place); d < best) {
          best = d;
          v = u;
        }
      if(v == from)
        return v;
    }
  }

  /// of the surface.
  double area() const {
    double sum = 0.;
    for(Index v = 0; v < number_of_vertices(); ++v)
      for(Index p = 0; p < ring(v).size(); ++p) {
        const Index a = ring(v)[p], b = ring(v)[ring(v).next(p)];
        if(v < a && v < b)
          sum += 0.5 * norm(cross(point(a) - point(v), point(b) - point(v)));
      }
    return sum;
  }

private:
  double squared_distance(Index v, const Vector& place) const {
    const Vector to = place - point(v);
    return dot(to, to);
  }

  void find_steps() {
    steps_.resize(finer_.neighbor.size());
    for(Index v = 0; v < finer_.number_of_vertices(); ++v)
      for(Index p = 0; p < finer_.ring(v).size(); ++p) {
        const Index from = corners_[v], to = corners_[finer_.ring(v)[p]];
        steps_[finer_.row_begin[v] + p] = from == to ? no_index : mesh_->ring(from).position(to);
        CGAL_assertion(from == to || mesh_->ring(from).position(to) < mesh_->ring(from).size());
      }
  }

  const Flat_mesh* mesh_; // to search on
  Flat_mesh finer_;
  std::vector<Index> corners_, steps_; // of the finer mesh, by vertex and by place in the rings
  std::vector<float> lengths_;         // of the edges in the rings, or empty
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_MESH_H
