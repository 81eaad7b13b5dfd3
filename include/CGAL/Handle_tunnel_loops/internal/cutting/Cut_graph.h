// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How many elements a component has.
struct Component_size
{
  std::size_t vertices = 0, halfedges = 0;

  /// V - E + F = 2 - 2 g, with 2 E = 3 F.
  std::size_t genus() const { return (2 + halfedges / 6 - vertices) / 2; }
};

/// the sizes of all components.
inline std::vector<Component_size> component_sizes(const Cut_problem& problem) {
  std::vector<Component_size> sizes(problem.mesh.seeds.size());
  for(Index v = 0; v < problem.mesh.number_of_vertices(); ++v) {
    Component_size& size = sizes[problem.mesh.component[v]];
    ++size.vertices;
    size.halfedges += problem.halfedges.end(v) - problem.halfedges.begin(v);
  }
  return sizes;
}

/// A set of edges, and how many of them meet at each vertex.
class Cut_graph
{
public:
  explicit Cut_graph(const Cut_problem& problem)
      : problem_(problem)
      , contains_(problem.halfedges.size(), 0)
      , degree_(problem.mesh.number_of_vertices(), 0) {}

  bool contains(Index h) const { return contains_[h] != 0; }
  Index degree(Index v) const { return degree_[v]; }

  void insert(Index h) { change(h, 1); }
  void erase(Index h) { change(h, 0); }

  /// takes out the dead end that begins at v, if there is one: up to a cone, a kept edge, or where
  /// several edges meet. Calls `tell(h)` for each edge.
  template <typename Function> void prune(Index v, const Function& tell) {
    while(degree_[v] == 1 && !problem_.is_cone(v)) {
      const Index h = only_edge(v);
      if(problem_.is_kept(h))
        return;
      erase(h);
      tell(h);
      v = problem_.halfedges.target(h);
    }
  }

  /// the next halfedge of the boundary of the opened surface, which is to its left.
  Index following(Index h) const {
    Index k = problem_.halfedges.twin(h);
    do
      k = problem_.halfedges.before(k);
    while(!contains(k));
    return k;
  }

  /// the cycle of the boundary that a halfedge of the cut is on, from there.
  std::vector<Index> boundary_from(Index begin) const {
    std::vector<Index> boundary;
    Index h = begin;
    do {
      boundary.push_back(h);
      h = following(h);
    } while(h != begin);
    return boundary;
  }

private:
  void change(Index h, char value) {
    const Index twin = problem_.halfedges.twin(h);
    if(contains_[h] == value)
      return;
    contains_[h] = contains_[twin] = value;
    const Index change = value ? Index(1) : static_cast<Index>(-1);
    degree_[problem_.halfedges.source(h)] += change;
    degree_[problem_.halfedges.source(twin)] += change;
  }

  Index only_edge(Index v) const {
    Index h = problem_.halfedges.begin(v);
    while(!contains(h))
      ++h;
    return h;
  }

  const Cut_problem& problem_;
  std::vector<char> contains_; // by halfedge
  std::vector<Index> degree_;  // by vertex
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_GRAPH_H
