// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_BAND_COMPONENTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_BAND_COMPONENTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
The advancing front of a layer as the paper has it (section 5): the triangles with a vertex that has
a value above a threshold and below one, and the connected components of these. Two triangles are
connected that share an edge.

The paper asks for one or two such vertices. Without the triangles that have three, which are inside
of the band, a band that is wider than an edge would be two fronts, its rims.
*/
class Band_components
{
public:
  Band_components(const Flat_mesh& mesh, double band_threshold)
      : mesh_(mesh)
      , threshold_(band_threshold)
      , triangle_(mesh.neighbor.size(), no_index) {}

  /// finds those of a layer, from its values. Returns their number.
  template <typename Values> Index find(const Values& values) {
    triangles_.clear();
    for(Index u = 0; u < mesh_.number_of_vertices(); ++u)
      if(is_in_band(values[u]))
        add_triangles_at(u);
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
    Graph graph(triangles_.size());
    for_each_corner([&](Index t, Index u, Index v) {
      const Index beside = triangle_[slot(mesh_, v, u)];
      if(beside != no_index && beside > t)
        boost::add_edge(t, beside, graph);
    });
    component_.resize(triangles_.size());
    return static_cast<Index>(boost::connected_components(graph, component_.data()));
  }

  /// calls `f(v, component)` for each vertex of each triangle, and forgets them.
  template <typename Function> void take(const Function& f) {
    for_each_corner([&](Index t, Index u, Index) { f(u, component_[t]); });
    for_each_corner([&](Index, Index u, Index v) { triangle_[slot(mesh_, u, v)] = no_index; });
  }

private:
  bool is_in_band(double value) const { return value > threshold_ && value < 1.; }

  // Those that are not known by another vertex.
  void add_triangles_at(Index u) {
    const Ring ring = mesh_.ring(u);
    for(Index i = 0; i < ring.size(); ++i) {
      const Index a = ring[i], b = ring[ring.next(i)];
      if(triangle_[mesh_.row_begin[u] + i] != no_index)
        continue;
      const auto t = static_cast<Index>(triangles_.size());
      triangles_.push_back({u, a, b});
      for(const auto& [v, w] : {std::pair(u, a), std::pair(a, b), std::pair(b, u)})
        triangle_[slot(mesh_, v, w)] = t;
    }
  }

  template <typename Function> void for_each_corner(const Function& f) const {
    for(Index t = 0; t < triangles_.size(); ++t)
      for(std::size_t i = 0; i < 3; ++i)
        f(t, triangles_[t][i], triangles_[t][(i + 1) % 3]);
  }

  const Flat_mesh& mesh_;
  double threshold_;
  std::vector<Index> triangle_; // by slot of an edge that has it on its left
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Index> component_;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_BAND_COMPONENTS_H
