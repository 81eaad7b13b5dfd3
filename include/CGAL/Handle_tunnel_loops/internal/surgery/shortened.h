// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHORTENED_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHORTENED_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/edges/Walk_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
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

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHORTENED_H
