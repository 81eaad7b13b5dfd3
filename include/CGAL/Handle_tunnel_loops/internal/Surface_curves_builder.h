// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURFACE_CURVES_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURFACE_CURVES_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Edge_walker.h>
#include <CGAL/Handle_tunnel_loops/internal/Surface_curves.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Turns closed walks on the edges of a mesh into `Surface_curves`.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
class Surface_curves_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  using Walk = std::vector<halfedge_descriptor>;

  Surface_curves_builder(const TriangleMesh& tm, VertexPointMap point, VertexIndexMap vertex_index)
      : tm_(tm)
      , point_(point)
      , vertex_index_(vertex_index) {}

  /// \p outward is 1 or -1 for each walk, as in `Surface_curves`.
  Surface_curves build(const std::vector<Walk>& walks, std::vector<int> outward) {
    // All walks first: crossings are of interest where there is a walk.
    for(const Walk& walk : walks)
      for(halfedge_descriptor h : walk)
        number_of(source(h, tm_));
    number_on_walks_ = static_cast<Index>(curves_.vertices.size());
    for(std::size_t i = 0; i < walks.size(); ++i)
      for(halfedge_descriptor h : walks[i])
        add_edge(h, static_cast<Index>(i));
    for(std::size_t i = 0; i < walks.size(); ++i)
      add_copy(walks[i], static_cast<Index>(i));
    curves_.walks.finish(curves_.edges.size());
    curves_.crossings.finish(curves_.edges.size());
    curves_.outward = std::move(outward);
    return std::move(curves_);
  }

  /// the index, in the mesh, of vertex v of the curves.
  Index original(Index v) const { return originals_[v]; }

private:
  Index index(vertex_descriptor v) const { return static_cast<Index>(get(vertex_index_, v)); }

  Index number_of(vertex_descriptor v) {
    const Index i = index(v);
    if(i >= numbers_.size())
      numbers_.resize((std::max)(std::size_t(i) + 1, 2 * numbers_.size()), no_index);
    if(numbers_[i] == no_index) {
      numbers_[i] = static_cast<Index>(curves_.vertices.size());
      curves_.vertices.push_back(coordinates(point_, v));
      originals_.push_back(i);
    }
    return numbers_[i];
  }

  std::uint64_t key(halfedge_descriptor h) const {
    return std::uint64_t(index(source(h, tm_))) << 32 | index(target(h, tm_));
  }

  // Each edge is known by one of its halfedges; a walk along the other counts as negative.
  bool is_reversed(halfedge_descriptor h) const {
    return index(target(h, tm_)) < index(source(h, tm_));
  }

  vertex_descriptor apex(halfedge_descriptor h) const { return target(next(h, tm_), tm_); }

  void add_edge(halfedge_descriptor h, Index loop) {
    const int sign = is_reversed(h) ? -1 : 1;
    if(sign < 0)
      h = opposite(h, tm_);
    const auto [it, is_new] = edges_.emplace(key(h), static_cast<Index>(curves_.edges.size()));
    if(is_new)
      curves_.edges.push_back({number_of(source(h, tm_)), number_of(target(h, tm_)),
                               number_of(apex(h)), number_of(apex(opposite(h, tm_)))});
    curves_.walks.add(it->second, loop, sign);
  }

  // The copy to the left of a walk, by the halfedges into whose faces it passes.
  Walk entered_halfedges(const Walk& walk) const {
    Walk entered;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const halfedge_descriptor end = walk[i + 1 == walk.size() ? 0 : i + 1];
      for(halfedge_descriptor h = next(walk[i], tm_); h != end; h = next(opposite(h, tm_), tm_))
        entered.push_back(opposite(h, tm_));
    }
    return entered;
  }

  void add_copy(const Walk& walk, Index loop) {
    const Walk entered = entered_halfedges(walk);
    for(std::size_t i = 0; i < entered.size(); ++i) {
      add_crossing(entered[i], loop);
      const halfedge_descriptor left = opposite(entered[i + 1 == entered.size() ? 0 : i + 1], tm_);
      // If the copy leaves a face where it has entered it, it has not been in it.
      if(left == next(entered[i], tm_))
        add_corner(source(left, tm_), source(entered[i], tm_), target(left, tm_), loop);
      else if(left != entered[i])
        add_corner(source(entered[i], tm_), target(entered[i], tm_), source(left, tm_), loop);
    }
  }

  // The vertices of the walks have the first numbers.
  bool is_on_walk(vertex_descriptor v) { return number_of(v) < number_on_walks_; }

  void add_crossing(halfedge_descriptor h, Index loop) {
    if(!is_on_walk(source(h, tm_)) || !is_on_walk(target(h, tm_)))
      return;
    const int sign = is_reversed(h) ? -1 : 1;
    const auto it = edges_.find(key(sign < 0 ? opposite(h, tm_) : h));
    if(it != edges_.end())
      curves_.crossings.add(it->second, loop, sign);
  }

  void
  add_corner(vertex_descriptor apex, vertex_descriptor from, vertex_descriptor to, Index loop) {
    curves_.corners.push_back({number_of(apex), number_of(from), number_of(to), loop});
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  VertexIndexMap vertex_index_;
  Surface_curves curves_;
  std::vector<Index> originals_; // by vertex of the curves
  std::vector<Index> numbers_;   // of vertices, by index in the mesh, as far as there are any
  Index number_on_walks_ = 0;
  std::unordered_map<std::uint64_t, Index> edges_; // by key
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURFACE_CURVES_BUILDER_H
