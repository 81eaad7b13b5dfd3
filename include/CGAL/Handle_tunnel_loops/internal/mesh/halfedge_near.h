// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_HALFEDGE_NEAR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_HALFEDGE_NEAR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL::Handle_tunnel_loops::internal {

/// the halfedge from `u` to `v`, or a null one. Those on the faces at `h`, if it is not null, are
/// looked at first: around a vertex there may be a million.
template <typename Mesh>
typename boost::graph_traits<Mesh>::halfedge_descriptor
halfedge_near(typename boost::graph_traits<Mesh>::halfedge_descriptor h,
              typename boost::graph_traits<Mesh>::vertex_descriptor u,
              typename boost::graph_traits<Mesh>::vertex_descriptor v,
              const Mesh& mesh) {
  const auto null = boost::graph_traits<Mesh>::null_halfedge();
  if(h != null)
    for(const auto side : {h, opposite(h, mesh)}) {
      if(is_border(side, mesh))
        continue;
      for(const auto e : {side, next(side, mesh), prev(side, mesh)}) {
        const auto a = source(e, mesh), b = target(e, mesh);
        if(a == u && b == v)
          return e;
        if(a == v && b == u)
          return opposite(e, mesh);
      }
    }
  const auto found = halfedge(u, v, mesh);
  return found.second ? found.first : null;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_HALFEDGE_NEAR_H
