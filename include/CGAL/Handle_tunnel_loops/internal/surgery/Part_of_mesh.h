// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PART_OF_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PART_OF_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The faces near a closed walk as a mesh of their own: those at the walk, and two rings around these.
It may be changed as far as the faces at the walk go: there, and around their vertices, all is as in
the whole mesh. At its end, faces have no twins.
*/
struct Part_of_mesh
{
  Part_of_mesh(const Surgery_mesh& whole, const Closed_walk& walk_of_whole)
      : vertices(walk_of_whole)
      , walk(walk_of_whole) {
    for(int ring = 0; ring < 3; ++ring) {
      make_set(vertices);
      for(Index v : vertices)
        whole.for_each_outgoing(v, [&](Index h) { faces.push_back(Surgery_mesh::face(h)); });
      make_set(faces);
      vertices = vertices_of(whole, faces);
    }
    for(Index& v : walk)
      v = position(v, vertices);
    std::vector<Surgery_mesh::Point> points;
    for(Index v : vertices)
      points.push_back(whole.point(v));
    std::vector<Surgery_mesh::Face> corners;
    std::vector<Index> twins;
    for(Index f : faces) {
      corners.push_back(whole.corners(f));
      for(Index& v : corners.back())
        v = position(v, vertices);
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        twins.push_back(halfedge_of_part(whole.twin(h)));
    }
    mesh = Surgery_mesh(std::move(points), std::move(corners), std::move(twins));
    const Index first_hub = number_below(whole.first_hub());
    mesh.set_hubs(first_hub, number_below(whole.first_hub() + whole.number_of_hubs()) - first_hub);
  }

  std::vector<Index> vertices, faces; ///< of the whole mesh by number, in ascending order
  Closed_walk walk;                   ///< on the part
  Surgery_mesh mesh;

private:
  static Index position(Index i, const std::vector<Index>& set) {
    const auto it = std::lower_bound(set.begin(), set.end(), i);
    return it != set.end() && *it == i ? static_cast<Index>(it - set.begin()) : no_index;
  }

  Index halfedge_of_part(Index h) const {
    const Index f = position(Surgery_mesh::face(h), faces);
    return f == no_index ? no_index : 3 * f + h % 3;
  }

  Index number_below(Index v) const {
    return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                              vertices.begin());
  }
};

/// splits an edge at its midpoint. Its two faces become four, which follow each other: the first
/// two are parts of the face to the left of the halfedge.
inline void split_edge(Surgery_mesh& mesh, Index h) {
  CGAL_precondition(h != no_index);
  const Index g = mesh.twin(h), u = mesh.source(h), v = mesh.target(h);
  const Index left = mesh.target(mesh.next(h)), right = mesh.target(mesh.next(g));
  const Index m = mesh.add_vertex(CGAL::midpoint(mesh.point(u), mesh.point(v)));
  const auto [first, second] = std::minmax({mesh.face(h), mesh.face(g)});
  mesh.replace({first, second}, {{u, m, left}, {m, v, left}, {v, m, right}, {m, u, right}});
}

/*!
splits, at their midpoints, the edges that begin on a simple closed walk and are not part of it. The
faces at the walk are an annulus then, whatever they were: no other edge joins two vertices of the
walk, and the edges to its neighbours end at vertices of their own. Returns of which faces those
that are new are parts.
*/
inline std::vector<Index> split_edges_beside(Surgery_mesh& mesh, const Closed_walk& walk) {
  using Ends = std::pair<Index, Index>;
  CGAL_precondition(is_simple(walk));
  const Index first_face = mesh.face_bound();
  std::vector<Index> on_walk = walk, parents;
  make_set(on_walk);
  std::vector<Ends> steps;
  for(std::size_t i = 0; i < walk.size(); ++i)
    steps.push_back(std::minmax(walk[i], after(walk, i)));
  make_set(steps);
  const auto parent = [&](Index f) { return f < first_face ? f : parents[f - first_face]; };
  // Those between two vertices of the walk come first.
  for(bool is_between : {true, false}) {
    std::vector<Ends> edges;
    for(Index u : on_walk)
      mesh.for_each_outgoing(u, [&](Index h) {
        const Ends ends = std::minmax(u, mesh.target(h));
        if(is_in(mesh.target(h), on_walk) == is_between && !is_in(ends, steps))
          edges.push_back(ends);
      });
    make_set(edges);
    for(const Ends& e : edges) {
      const Index h = mesh.halfedge(e.first, e.second);
      const Index left = parent(mesh.face(h)), right = parent(mesh.face(mesh.twin(h)));
      parents.insert(parents.end(), {left, left, right, right});
      split_edge(mesh, h);
    }
  }
  return parents;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PART_OF_MESH_H
