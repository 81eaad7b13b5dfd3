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

#include <CGAL/Handle_tunnel_loops/internal/edges/shortest_walk_beside.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A place on an edge: `source + ratio * (target - source)`.
struct Place_on_edge
{
  Index source, target;
  double ratio;
};

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

/// the shortest closed walk on the edges beside a loop, homotopic to it.
inline Closed_walk walk_beside(const Surgery_mesh& mesh, const std::vector<Place_on_edge>& places) {
  std::vector<Edge_ends> ends;
  for(const Place_on_edge& p : places)
    ends.push_back({p.ratio == 1. ? p.target : p.source, p.ratio == 0. ? p.source : p.target});
  Closed_walk walk =
      shortest_walk_beside(ends, [&](Index u, Index v) { return distance(mesh, u, v); });
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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CLOSED_WALKS_H
