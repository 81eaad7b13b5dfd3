// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GRID_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GRID_GRAPH_H

#include "Field.h"
#include "Random.h"

#include <boost/pending/disjoint_sets.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// The graph of a box of cubic cells of side one, with as many edges taken away as leaves it
/// connected and with a given number of independent cycles, and with its nodes moved a little.
class Grid_graph
{
public:
  Grid_graph(std::size_t cycles, Random& random, double jitter = 0.12) {
    choose_size(cycles);
    place_nodes(random, jitter);
    choose_edges(cycles, random);
  }

  /// the edges, as pairs of points.
  std::vector<std::pair<Vector, Vector>> segments() const {
    return segments_with_cycles((std::numeric_limits<std::size_t>::max)());
  }

  /// those of a connected subgraph with all nodes and only so many cycles.
  std::vector<std::pair<Vector, Vector>> segments_with_cycles(std::size_t cycles) const {
    std::vector<std::pair<Vector, Vector>> segments;
    for(std::size_t i = 0; i < edges_.size(); ++i) {
      if(closes_cycle_[i] && cycles == 0)
        continue;
      cycles -= closes_cycle_[i];
      segments.emplace_back(nodes_[edges_[i].first], nodes_[edges_[i].second]);
    }
    return segments;
  }

private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  std::size_t number_of_nodes() const { return std::size_t(size_[0]) * size_[1] * size_[2]; }

  std::size_t number_of_edges() const {
    const std::size_t x = size_[0], y = size_[1], z = size_[2];
    return (x - 1) * y * z + x * (y - 1) * z + x * y * (z - 1);
  }

  /// the smallest box close to a cube that has the cycles, and an edge.
  void choose_size(std::size_t cycles) {
    size_ = {2, 1, 1};
    for(int i = 1; number_of_edges() + 1 < number_of_nodes() + cycles; i = (i + 1) % 3)
      ++size_[i];
  }

  void place_nodes(Random& random, double jitter) {
    const auto moved = [&](std::uint32_t i) { return i + random.uniform(-jitter, jitter); };
    for(std::uint32_t k = 0; k < size_[2]; ++k)
      for(std::uint32_t j = 0; j < size_[1]; ++j)
        for(std::uint32_t i = 0; i < size_[0]; ++i) {
          const double x = moved(i), y = moved(j), z = moved(k);
          nodes_.push_back(Vector(x, y, z));
        }
  }

  std::vector<Edge> all_edges() const {
    std::vector<Edge> edges;
    const std::array<std::uint32_t, 3> stride = {1, size_[0], size_[0] * size_[1]};
    for(std::uint32_t node = 0; node < number_of_nodes(); ++node)
      for(int axis = 0; axis < 3; ++axis)
        if(node / stride[axis] % size_[axis] + 1 < size_[axis])
          edges.emplace_back(node, node + stride[axis]);
    return edges;
  }

  /// keeps a random spanning tree and, of the other edges, as many as there are to be cycles.
  void choose_edges(std::size_t cycles, Random& random) {
    std::vector<Edge> edges = all_edges();
    random.shuffle(edges);
    boost::disjoint_sets_with_storage<> components(number_of_nodes());
    for(const auto& [a, b] : edges) {
      const bool closes_cycle = components.find_set(a) == components.find_set(b);
      if(closes_cycle && cycles == 0)
        continue;
      cycles -= closes_cycle;
      components.union_set(a, b);
      edges_.emplace_back(a, b);
      closes_cycle_.push_back(closes_cycle);
    }
  }

  std::array<std::uint32_t, 3> size_; ///< in nodes
  std::vector<Vector> nodes_;
  std::vector<Edge> edges_;
  std::vector<char> closes_cycle_; ///< with the edges before it
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GRID_GRAPH_H
