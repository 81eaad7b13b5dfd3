// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Function_on_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A total order of the vertices: by their values, and by the caller's indices where these are
/// equal. So the order does not depend on how the flat mesh numbers its vertices.
///
/// Hubs are in it if the surface is swept with its caps. If not, they have the highest ranks, and
/// the contours end where they come to one.
class Sweep_order
{
public:
  /// \p key gives an unsigned integer for each vertex that is swept.
  template <typename Key>
  Sweep_order(Execution execution, const Flat_mesh& mesh, const Key& key, bool has_caps = true)
      : vertices_(has_caps ? mesh.number_of_vertices()
                           : mesh.number_of_vertices() - mesh.number_of_hubs)
      , rank_(mesh.number_of_vertices()) {
    std::vector<Entry> entries(vertices_.size());
    for_each_index(execution, entries.size(), [&](std::size_t i) {
      const Index v = static_cast<Index>(i);
      entries[i] = {key(v), mesh.original[v], v};
    });
    sort(entries);
    CGAL_expensive_assertion(
        std::adjacent_find(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
          return std::make_pair(a.key, a.original) >= std::make_pair(b.key, b.original);
        }) == entries.end());
    for_each_index(execution, entries.size(), [&](std::size_t r) {
      vertices_[r] = entries[r].vertex;
      rank_[entries[r].vertex] = static_cast<Index>(r);
    });
    std::iota(rank_.begin() + static_cast<std::ptrdiff_t>(entries.size()), rank_.end(),
              static_cast<Index>(entries.size()));
  }

  /// the vertices that are swept, from the lowest to the highest.
  const std::vector<Index>& vertices() const { return vertices_; }

  /// whether a vertex is a hub that is not swept: there is a hole in its place.
  bool is_hole(Index v) const { return rank_[v] >= vertices_.size(); }
  bool has_holes() const { return vertices_.size() < rank_.size(); }

  Index rank(Index v) const { return rank_[v]; }

private:
  struct Entry
  {
    std::uint64_t key;
    Index original, vertex;
  };

  static void sort(std::vector<Entry>& entries) {
    boost::sort::spreadsort::integer_sort(
        entries.begin(), entries.end(),
        [](const Entry& e, unsigned shift) { return e.key >> shift; },
        [](const Entry& a, const Entry& b) { return a.key < b.key; });
    const auto by_index = [](const Entry& a, const Entry& b) { return a.original < b.original; };
    for(auto first = entries.begin(); first != entries.end();) {
      auto last = first + 1;
      while(last != entries.end() && last->key == first->key)
        ++last;
      std::sort(first, last, by_index);
      first = last;
    }
  }

  std::vector<Index> vertices_, rank_;
};

/// The sum of places with weights; a front is summed up by the middles of the edges that it
/// crosses, each with about the length that the front has around it.
struct Front_mean
{
  Vector sum = {0., 0., 0.};
  double weight = 0.;

  Front_mean& operator+=(const Front_mean& other) {
    sum = sum + other.sum;
    weight += other.weight;
    return *this;
  }
  Front_mean& operator-=(const Front_mean& other) {
    sum = sum - other.sum;
    weight -= other.weight;
    return *this;
  }

  /// about the length of the front: on a regular triangulation each edge that it crosses counts
  /// with 1.73 edge lengths, and there are two of them on one.
  float girth() const { return static_cast<float>((std::max)(weight, 0.) / 3.46); }

  /// the mean of the places; `otherwise` if they weigh next to nothing, as on degenerate triangles.
  Vector mean(const Vector& otherwise) const {
    return weight > 1e-9 ? (1. / weight) * sum : otherwise;
  }
};

/// the part of a front that crosses the edge to the neighbour at a position in the ring of `v`; the
/// same from both ends of the edge. The vertices across it tell how far apart its neighbours are;
/// at a boundary, where the front ends, there is one.
inline Front_mean crossing_of_front(
    const Flat_mesh& mesh, const Sweep_order& order, Index v, Ring ring, Index position) {
  const Vector middle = 0.5 * (mesh.points[v] + mesh.points[ring[position]]);
  const auto across = [&](Index u) { return order.is_hole(u) ? middle : mesh.points[u]; };
  const double weight =
      norm(across(ring[ring.next(position)]) - across(ring[ring.previous(position)]));
  return {weight * middle, weight};
}

enum class Vertex_kind : Index { MINIMUM, REGULAR, SADDLE, MAXIMUM };

/// What the sweep needs to know of a vertex; gathered beforehand, because the sweep jumps through
/// memory and this does not.
struct Star
{
  Front_mean change; ///< of the front when it passes the vertex
  Index below;       ///< the slot, at a lower neighbour, of the edge to it; none at a minimum
  Vertex_kind kind;
};

/// the slot of the edge from `u` to its neighbour `v`, among those of `u`.
inline Index slot_of(const Flat_mesh& mesh, Index u, Index v) {
  const Index position = mesh.position(u, v);
  CGAL_precondition_msg(position < mesh.ring(u).size(), "they are neighbours");
  return mesh.row_begin[u] + position;
}

/// whether the vertex at a position of a ring belongs to a lower component of it. A hole may count
/// as either: so that a boundary is no further alternation, it is higher between lower vertices,
/// and lower between higher ones.
inline bool is_in_lower_component(const Sweep_order& order, Ring ring, Index position, Index rank) {
  const auto is_lower = [&](Index p) { return order.rank(ring[p]) < rank; };
  return order.is_hole(ring[position])
             ? !is_lower(ring.previous(position)) && !is_lower(ring.next(position))
             : is_lower(position);
}

inline Star star_of(const Flat_mesh& mesh, const Sweep_order& order, Index v) {
  const Ring ring = mesh.ring(v);
  const Index rank = order.rank(v);
  Star star = {{}, no_index, Vertex_kind::REGULAR};
  bool is_previous_lower = is_in_lower_component(order, ring, ring.size() - 1, rank);
  bool is_maximum = true;
  Index number_of_changes = 0;
  for(Index p = 0; p < ring.size(); ++p) {
    const bool is_lower = is_in_lower_component(order, ring, p, rank);
    number_of_changes += is_lower != is_previous_lower;
    is_previous_lower = is_lower;
    if(order.is_hole(ring[p]))
      continue;
    if(is_lower) {
      star.change -= crossing_of_front(mesh, order, v, ring, p);
      if(star.below == no_index)
        star.below = slot_of(mesh, ring[p], v);
    } else {
      star.change += crossing_of_front(mesh, order, v, ring, p);
      is_maximum = false;
    }
  }
  star.kind = star.below == no_index  ? Vertex_kind::MINIMUM
              : is_maximum            ? Vertex_kind::MAXIMUM
              : number_of_changes > 2 ? Vertex_kind::SADDLE
                                      : Vertex_kind::REGULAR;
  return star;
}

inline std::vector<Star>
sweep_stars(Execution execution, const Flat_mesh& mesh, const Sweep_order& order) {
  std::vector<Star> stars(mesh.number_of_vertices());
  for_each_index(execution, stars.size(),
                 [&](std::size_t v) { stars[v] = star_of(mesh, order, static_cast<Index>(v)); });
  return stars;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_ORDER_H
