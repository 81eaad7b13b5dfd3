// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_DUAL_CUT_CHECK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_DUAL_CUT_CHECK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Says in words why cuts along edges are not dual to loops, on the caller's mesh: a cut has to be
closed but for the boundary, and to cross its own loop once from left to right, as seen from the
loop, and no other loop, counted with sign.

Each loop is moved onto the edges and pushed to its left; what it crosses there is added up. Where
that leads through a hole, the loop passes between its vertex and the rest of the hole, and crosses
what ends at the vertex.
*/
template <typename TriangleMesh, typename VertexIndexMap> class Dual_cut_check
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Numbers = std::map<std::size_t, std::int64_t>; // by cut

public:
  using Cut = std::vector<std::pair<halfedge_descriptor, std::int64_t>>;
  using Walk = std::vector<vertex_descriptor>; ///< closed

  Dual_cut_check(const TriangleMesh& tm, VertexIndexMap vertex_index, const std::vector<Cut>& cuts)
      : tm_(tm)
      , vertex_index_(vertex_index) {
    for(std::size_t j = 0; j < cuts.size(); ++j)
      for(const auto& [h, times] : cuts[j]) {
        const std::size_t u = index(source(h, tm)), v = index(target(h, tm));
        along_[{u, v}][j] += times;
        along_[{v, u}][j] -= times;
        ending_[v][j] += times;
        ending_[u][j] -= times;
      }
  }

  /// the vertices of a loop that is moved onto the edges.
  template <typename Loop> Walk walk_beside(const Loop& loop) const {
    Walk walk;
    for(const auto& step : loop.steps())
      if(const vertex_descriptor v =
             step.ratio == 1. ? target(step.halfedge, tm_) : source(step.halfedge, tm_);
         walk.empty() || walk.back() != v)
        walk.push_back(v);
    while(walk.size() > 1 && walk.back() == walk.front())
      walk.pop_back();
    return walk;
  }

  /// empty if the cuts are dual to the loops, one by one.
  std::string failure(const std::vector<Walk>& loops) const {
    for(const vertex_descriptor v : vertices(tm_))
      if(const auto end = ending_.find(index(v)); end != ending_.end() && !is_on_boundary(v))
        for(const auto& [j, times] : end->second)
          if(times != 0)
            return "cut " + std::to_string(j) + " ends within the surface";
    for(std::size_t i = 0; i < loops.size(); ++i) {
      Numbers numbers = crossings(loops[i]);
      numbers[i] += 1;
      for(const auto& [j, number] : numbers)
        if(number != 0)
          return "cut " + std::to_string(j) + " does not cross loop " + std::to_string(i) +
                 " as often as it should";
    }
    return {};
  }

private:
  std::size_t index(vertex_descriptor v) const { return get(vertex_index_, v); }

  bool is_on_boundary(vertex_descriptor v) const { return bool(CGAL::is_border(v, tm_)); }

  template <typename Key>
  static void add(const std::map<Key, Numbers>& all, const Key& key, Numbers& sum) {
    if(const auto found = all.find(key); found != all.end())
      for(const auto& [j, times] : found->second)
        sum[j] += times;
  }

  // From the left of a cut to its right.
  Numbers crossings(const Walk& walk) const {
    Numbers sum;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const vertex_descriptor before = walk[i == 0 ? walk.size() - 1 : i - 1], v = walk[i],
                              after = walk[i + 1 == walk.size() ? 0 : i + 1];
      bool passes_hole = false;
      for(halfedge_descriptor h = halfedge(before, v, tm_).first;; h = opposite(h, tm_)) {
        passes_hole = passes_hole || is_border(h, tm_);
        h = next(h, tm_);
        if(target(h, tm_) == after)
          break;
        add(along_, {index(v), index(target(h, tm_))}, sum);
      }
      if(passes_hole)
        add(ending_, index(v), sum);
    }
    return sum;
  }

  const TriangleMesh& tm_;
  VertexIndexMap vertex_index_;
  std::map<std::pair<std::size_t, std::size_t>, Numbers> along_; // by ends of edges
  std::map<std::size_t, Numbers> ending_;                        // by vertex, what arrives there
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_DUAL_CUT_CHECK_H
