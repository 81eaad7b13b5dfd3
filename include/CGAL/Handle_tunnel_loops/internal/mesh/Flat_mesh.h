// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The neighbours of a vertex in counterclockwise order; consecutive ones (and the last and the
/// first) form a face with the vertex.
class Ring
{
public:
  CGAL_HTL_HOST_DEVICE Ring(const Index* first, Index size)
      : first_(first)
      , size_(size) {}

  CGAL_HTL_HOST_DEVICE Index size() const { return size_; }
  CGAL_HTL_HOST_DEVICE Index operator[](Index i) const { return first_[i]; }
  CGAL_HTL_HOST_DEVICE const Index* begin() const { return first_; }
  CGAL_HTL_HOST_DEVICE const Index* end() const { return first_ + size_; }

  CGAL_HTL_HOST_DEVICE Index position(Index v) const {
    Index i = 0;
    CGAL_HTL_NO_UNROLL
    while(i < size_ && first_[i] != v)
      ++i;
    return i;
  }
  CGAL_HTL_HOST_DEVICE Index next(Index i) const { return i + 1 == size_ ? 0 : i + 1; }
  CGAL_HTL_HOST_DEVICE Index previous(Index i) const { return i == 0 ? size_ - 1 : i - 1; }

  /// the vertices before and after `v`, counterclockwise.
  CGAL_HTL_HOST_DEVICE Index after(Index v) const { return first_[next(position(v))]; }
  CGAL_HTL_HOST_DEVICE Index before(Index v) const { return first_[previous(position(v))]; }

private:
  const Index* first_;
  Index size_;
};

/// the vertex after `v` in the ring of `u`, and the one before it: the third corners of the faces
/// to the left and to the right of their edge. Looked up where there are fewer neighbours: a vertex
/// may have a million.
CGAL_HTL_HOST_DEVICE inline Index
after(const Ring& ring_of_u, const Ring& ring_of_v, Index u, Index v) {
  return ring_of_u.size() <= ring_of_v.size() ? ring_of_u.after(v) : ring_of_v.before(u);
}
CGAL_HTL_HOST_DEVICE inline Index
before(const Ring& ring_of_u, const Ring& ring_of_v, Index u, Index v) {
  return ring_of_u.size() <= ring_of_v.size() ? ring_of_u.before(v) : ring_of_v.after(u);
}

/// A closed oriented triangle mesh as plain arrays. The ordered rings hold all of its
/// connectivity: (u, ring[i], ring[i+1]) are the faces at u. Vertices are numbered along a
/// space-filling curve, so that neighbours are near in memory; coordinates are moved and scaled
/// into the unit box, so that neither underflow nor overflow has to be thought of again.
///
/// Each boundary curve of a surface is closed by a cap: a fan of faces around a vertex more, its
/// hub. What is asked of the surface with its caps can be asked of closed surfaces only; but a
/// curve on the surface crosses an edge to a hub at its other end.
struct Flat_mesh
{
  /// The position of a neighbour in the ring of a vertex.
  struct Place_in_ring
  {
    Index vertex, neighbor, position;

    bool operator<(const Place_in_ring& other) const {
      return std::tie(vertex, neighbor) < std::tie(other.vertex, other.neighbor);
    }
  };

  Uninitialized_vector<Vector> points;
  Uninitialized_vector<Index> row_begin; ///< size n + 1
  Uninitialized_vector<Index> neighbor;  ///< the rings, one after the other
  Uninitialized_vector<Index> original;  ///< the caller's index of each vertex; larger of hubs
  Uninitialized_vector<Index> component; ///< by vertex, a position in `seeds`
  std::vector<Index> seeds;              ///< one vertex of each component
  double half_scale = 0.5;               ///< half of the caller's unit of length / unit of `points`
  std::size_t genus = 0;                 ///< summed over the components
  Index first_hub = 0;                   ///< the hubs come after all other vertices
  Index number_of_hubs = 0;              ///< of the boundary curves
  std::vector<Place_in_ring> places_in_long_rings; ///< sorted

  bool is_hub(Index v) const { return v - first_hub < number_of_hubs; }

  std::size_t number_of_vertices() const { return points.size(); }
  std::size_t number_of_faces() const { return neighbor.size() / 3; }

  Ring ring(Index v) const {
    return Ring(neighbor.data() + row_begin[v], row_begin[v + 1] - row_begin[v]);
  }
  /// the caller's index of a vertex; of a hub, that of one on its curve.
  Index index_of_caller(Index v) const { return original[is_hub(v) ? ring(v)[0] : v]; }

  /// whether the edge of two neighbours leads to a hub.
  bool is_spoke(Index u, Index v) const { return is_hub(u) || is_hub(v); }

  /// the faces that are no part of the surface.
  std::size_t number_of_faces_of_caps() const {
    return number_of_hubs == 0 ? 0 : row_begin[first_hub + number_of_hubs] - row_begin[first_hub];
  }

  /// the position of a neighbour in the ring of a vertex, as `Ring::position()` says, which asks
  /// one after the other.
  Index position(Index v, Index neighbor_of_v) const {
    const Ring around = ring(v);
    if(around.size() <= many_neighbors || places_in_long_rings.empty())
      return around.position(neighbor_of_v);
    const auto place = std::lower_bound(places_in_long_rings.begin(), places_in_long_rings.end(),
                                        Place_in_ring{v, neighbor_of_v, 0});
    return place != places_in_long_rings.end() && place->vertex == v &&
                   place->neighbor == neighbor_of_v
               ? place->position
               : around.size();
  }

  double edge_length(Index u, Index v) const {
    const Vector to = points[v] - points[u];
    return rounded_length(to[0], to[1], to[2]);
  }

  /// makes positions in long rings known, once all rings are there.
  void find_places_in_long_rings() {
    for(Index v = 0; v < number_of_vertices(); ++v)
      if(const Ring around = ring(v); around.size() > many_neighbors)
        for(Index p = 0; p < around.size(); ++p)
          places_in_long_rings.push_back({v, around[p], p});
    std::sort(places_in_long_rings.begin(), places_in_long_rings.end());
  }

  /// sets the genus, once the components are known.
  void count_handles() {
    // V - E + F = 2 c - 2 g, with 2 E = 3 F halfedges.
    genus = (2 * seeds.size() + number_of_faces() / 2 - number_of_vertices()) / 2;
  }

  /// a length, or a vector, as the caller measures it: what is in the range of doubles stays so.
  template <typename Length> Length in_units_of_caller(const Length& length) const {
    return 2. * (half_scale * length);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_H
