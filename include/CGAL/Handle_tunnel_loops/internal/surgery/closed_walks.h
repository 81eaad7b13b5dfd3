// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CLOSED_WALKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CLOSED_WALKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Walk_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Loop_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace boost {

/// As much of a graph as closed walks need.
template <> struct graph_traits<CGAL::Handle_tunnel_loops::internal::Surgery_mesh>
{
  using vertex_descriptor = CGAL::Handle_tunnel_loops::internal::Index;
  using halfedge_descriptor = CGAL::Handle_tunnel_loops::internal::Index;
};

} // namespace boost

namespace CGAL::Handle_tunnel_loops::internal {

/// Closed walks on the edges, as their vertices in order.
using Closed_walk = std::vector<Index>;

/// the vertex that comes after the i-th.
inline Index after(const Closed_walk& walk, std::size_t i) {
  return walk[i + 1 == walk.size() ? 0 : i + 1];
}

/// whether all steps of a walk are edges of the mesh as it is by now.
inline bool is_intact(const Surgery_mesh& mesh, const Closed_walk& walk) {
  for(std::size_t i = 0; i < walk.size(); ++i)
    if(mesh.halfedge(walk[i], after(walk, i)) == no_index)
      return false;
  return true;
}

/// along an edge; infinite to a hub, so that walks stay on the surface.
inline double distance(const Surgery_mesh& mesh, Index u, Index v) {
  if(mesh.is_hub(u) || mesh.is_hub(v))
    return std::numeric_limits<double>::infinity();
  return std::sqrt(CGAL::squared_distance(mesh.point(u), mesh.point(v)));
}

/// the halfedges of the steps of a walk that is intact.
inline std::vector<Index> halfedges_of(const Surgery_mesh& mesh, const Closed_walk& walk) {
  std::vector<Index> halfedges;
  for(std::size_t i = 0; i < walk.size(); ++i)
    halfedges.push_back(mesh.halfedge(walk[i], after(walk, i)));
  return halfedges;
}

/// whether a closed walk comes to no vertex twice.
inline bool is_simple(Closed_walk walk) {
  const std::size_t size = walk.size();
  make_set(walk);
  return walk.size() == size;
}

/// whether a closed walk comes to the boundary of the surface.
inline bool is_on_boundary(const Surgery_mesh& mesh, const Closed_walk& walk) {
  return std::any_of(walk.begin(), walk.end(), [&](Index v) { return mesh.is_on_boundary(v); });
}

/// of a closed walk.
inline double length(const Surgery_mesh& mesh, const Closed_walk& walk) {
  double sum = 0.;
  for(std::size_t i = 0; i < walk.size(); ++i)
    sum += distance(mesh, walk[i], after(walk, i));
  return sum;
}

inline Surgery_mesh::Point point_at(const Surgery_mesh& mesh, const Place_on_edge& place) {
  return CGAL::barycenter(mesh.point(place.source), 1. - place.ratio, mesh.point(place.target),
                          place.ratio);
}

/// the vertices of a walk.
inline std::vector<Place_on_edge> places_of(const Closed_walk& walk) {
  std::vector<Place_on_edge> places;
  for(std::size_t i = 0; i < walk.size(); ++i)
    places.push_back({walk[i], after(walk, i), 0.});
  return places;
}

/// the shortest closed walk on the edges beside a loop, homotopic to it.
inline Closed_walk walk_beside(const Surgery_mesh& mesh, const std::vector<Place_on_edge>& places) {
  std::vector<Edge_ends> ends;
  for(const Place_on_edge& p : places)
    ends.push_back({p.ratio == 1. ? p.target : p.source, p.ratio == 0. ? p.source : p.target});
  Closed_walk walk =
      places_of_shortest_walk_beside(ends, [&](Index u, Index v) { return distance(mesh, u, v); });
  remove_spurs(walk);
  return walk;
}

/// A part of a closed walk that comes to no vertex twice: the longer part, where there are two.
inline Closed_walk simple_part(Closed_walk walk) {
  std::unordered_map<Index, std::size_t> seen;
  for(std::size_t i = 0; i < walk.size();) {
    const auto [it, is_new] = seen.insert({walk[i], i});
    if(is_new) {
      ++i;
      continue;
    }
    const std::size_t begin = it->second;
    Closed_walk inner(walk.begin() + begin, walk.begin() + i);
    walk.erase(walk.begin() + begin, walk.begin() + i);
    if(inner.size() > walk.size())
      walk.swap(inner);
    remove_spurs(walk);
    seen.clear();
    i = 0;
  }
  return walk;
}

// ---- a walk beside the boundary

/// the neighbours of a vertex on the boundary, from one on the boundary to the other.
inline std::vector<Index> neighbors_on_surface(const Surgery_mesh& mesh, Index v) {
  CGAL_precondition(mesh.is_on_boundary(v));
  std::vector<Index> neighbors;
  mesh.for_each_outgoing(v, [&](Index h) { neighbors.push_back(mesh.target(h)); });
  const auto hub =
      std::find_if(neighbors.begin(), neighbors.end(), [&](Index u) { return mesh.is_hub(u); });
  std::rotate(neighbors.begin(), hub, neighbors.end());
  neighbors.erase(neighbors.begin());
  return neighbors;
}

/// leads a closed walk around its vertices on the boundary, from neighbour to neighbour.
inline Closed_walk around_boundary(const Surgery_mesh& mesh, const Closed_walk& walk) {
  Closed_walk around;
  for(std::size_t i = 0; i < walk.size(); ++i) {
    if(!mesh.is_on_boundary(walk[i])) {
      around.push_back(walk[i]);
      continue;
    }
    const std::vector<Index> neighbors = neighbors_on_surface(mesh, walk[i]);
    const Index before = walk[i == 0 ? walk.size() - 1 : i - 1];
    const auto from = std::find(neighbors.begin(), neighbors.end(), before),
               to = std::find(neighbors.begin(), neighbors.end(), after(walk, i));
    if(from < to)
      around.insert(around.end(), from + 1, to);
    else if(to < from)
      around.insert(around.end(), std::make_reverse_iterator(from),
                    std::make_reverse_iterator(to + 1));
  }
  remove_spurs(around);
  return around;
}

/// a homotopic walk beside the boundary where the given one comes to it; or that one, where the
/// surface is too narrow.
inline Closed_walk led_off_boundary(const Surgery_mesh& mesh, const Closed_walk& walk) {
  constexpr int most_rounds = 4; // where faces have all their corners on the boundary
  Closed_walk inner = walk;
  for(int round = 0; round < most_rounds && is_on_boundary(mesh, inner); ++round) {
    inner = around_boundary(mesh, inner);
    if(inner.size() < 3 || !is_intact(mesh, inner))
      return walk;
  }
  return inner;
}

// ---- a shorter walk

inline Index next(Index h, const Surgery_mesh&) { return Surgery_mesh::next(h); }
inline Index prev(Index h, const Surgery_mesh&) { return Surgery_mesh::previous(h); }
inline Index opposite(Index h, const Surgery_mesh& mesh) { return mesh.twin(h); }
inline Index target(Index h, const Surgery_mesh& mesh) { return mesh.target(h); }
inline bool is_border(Index h, const Surgery_mesh& mesh) {
  return mesh.is_in_cap(Surgery_mesh::face(h));
}

/// a shorter closed walk in the homotopy class of another one, that comes to no vertex twice where
/// that can be.
inline Closed_walk shortened(const Surgery_mesh& mesh, const Closed_walk& walk) {
  std::vector<Index> halfedges;
  if(walk.size() > 1)
    halfedges = halfedges_of(mesh, walk);
  const auto length_of = [&](Index h) { return distance(mesh, mesh.source(h), mesh.target(h)); };
  Walk_improvement<Surgery_mesh, decltype(length_of)> improvement(mesh, length_of,
                                                                  std::move(halfedges));
  improvement.shorten();
  improvement.separate();
  Closed_walk shorter;
  for(Index h : improvement.walk())
    shorter.push_back(mesh.source(h));
  return shorter;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CLOSED_WALKS_H
