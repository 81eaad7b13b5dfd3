// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The classes of closed walks on a surface with boundary, by another way than that of the package:
// faces are collapsed from the boundary until a graph is left.

#ifndef HTL_TEST_HOMOLOGY_BY_COLLAPSE_H
#define HTL_TEST_HOMOLOGY_BY_COLLAPSE_H

#include "Determinant.h"
#include "Edge_walks.h"

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/// Coordinates in H1 of a surface each component of which has a boundary.
template <typename TriangleMesh> class Homology_by_collapse
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Edge = typename Traits::edge_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Vertex = typename Traits::vertex_descriptor;

public:
  explicit Homology_by_collapse(const TriangleMesh& tm)
      : tm_(tm) {
    collapse();
    find_cycles();
  }

  /// the first Betti number.
  std::size_t rank() const { return number_.size(); }

  std::vector<Integer> coordinates(const Edge_walk<TriangleMesh>& walk) const {
    std::map<Edge, Integer> chain;
    for(const Halfedge h : walk)
      chain[edge(h, tm_)] += sign(h);
    for(const Halfedge free : collapses_) {
      const Integer value = chain[edge(free, tm_)] * sign(free);
      if(value != 0)
        for(const Halfedge h : CGAL::halfedges_around_face(free, tm_))
          chain[edge(h, tm_)] -= value * sign(h);
    }
    std::vector<Integer> result(rank(), 0);
    for(const auto& [e, value] : chain)
      if(const auto it = number_.find(e); it != number_.end())
        result[it->second] = value;
    return result;
  }

private:
  int sign(Halfedge h) const { return source(h, tm_) < target(h, tm_) ? 1 : -1; }

  // Each halfedge is that of a face whose edge belongs to no other face any more.
  void collapse() {
    std::vector<Halfedge> open;
    std::map<typename Traits::face_descriptor, bool> is_gone;
    const auto has_face = [&](Halfedge h) { return !is_border(h, tm_) && !is_gone[face(h, tm_)]; };
    for(const Halfedge h : halfedges(tm_))
      if(is_border(h, tm_))
        open.push_back(opposite(h, tm_));
    while(!open.empty()) {
      const Halfedge h = open.back();
      open.pop_back();
      if(!has_face(h) || has_face(opposite(h, tm_)))
        continue;
      is_gone[face(h, tm_)] = true;
      collapses_.push_back(h);
      is_collapsed_[edge(h, tm_)] = true;
      for(const Halfedge side : {next(h, tm_), prev(h, tm_)})
        if(has_face(opposite(side, tm_)))
          open.push_back(opposite(side, tm_));
    }
  }

  void find_cycles() {
    std::map<Vertex, std::size_t> ranks;
    std::map<Vertex, Vertex> parents;
    boost::disjoint_sets sets(boost::make_assoc_property_map(ranks),
                              boost::make_assoc_property_map(parents));
    for(const Vertex v : vertices(tm_))
      sets.make_set(v);
    for(const Edge e : edges(tm_)) {
      if(is_collapsed_[e])
        continue;
      const Vertex u = sets.find_set(source(e, tm_)), v = sets.find_set(target(e, tm_));
      if(u != v)
        sets.link(u, v);
      else
        number_.emplace(e, number_.size());
    }
  }

  const TriangleMesh& tm_;
  std::vector<Halfedge> collapses_;
  std::map<Edge, bool> is_collapsed_;
  std::map<Edge, std::size_t> number_; // of the edges that each close a cycle of the graph
};

#endif // HTL_TEST_HOMOLOGY_BY_COLLAPSE_H
