// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WIDEST_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WIDEST_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Edge_names.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Named_forest.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A closed walk on a graph along which the largest balls fit.
struct Widest_cycle
{
  double radius; ///< the least distance of the points along it
  Linking_row row;
  std::vector<Ball_network::Node> balls; ///< of those of a graph, the first is the smallest
};

/*!
The widest closed walks of a network of balls that are independent by their linking numbers.

Edges are taken in the order of falling radius (Kruskal). One that joins what is not yet joined
becomes one of a forest; another one closes a cycle with it, of which nothing but the linking
numbers matters. They are added up from the roots, as one random number first, by which most cycles
are found to be nothing new.

Edges come in portions, the widest first, until there are enough cycles.
*/
class Widest_cycles
{
public:
  using Width = float Ball_network::Edge::*;

  /// \p width is which of the radii of edges counts.
  Widest_cycles(Execution execution, const Ball_network& graph, Edge_names& names, Width width)
      : execution_(execution)
      , graph_(graph)
      , names_(names)
      , width_(width)
      , order_(graph.edges.size())
      , joined_(graph.nodes.size()) {
    std::iota(order_.begin(), order_.end(), Index(0));
  }

  /// that many, the widest first; fewer if there are not so many.
  std::vector<Widest_cycle> find(std::size_t number) {
    std::size_t begin = 0, size = order_.size() / 16 + 1024;
    while(cycles_.size() < number && begin < order_.size()) {
      const std::size_t end = (std::min)(begin + size, order_.size());
      take_portion(begin, end, number);
      begin = end;
      size += size / 2;
    }
    return std::move(cycles_);
  }

private:
  /// An edge that closes a cycle.
  struct Closing
  {
    Index edge;
    std::uint64_t name;
  };

  bool is_before(Index e, Index f) const {
    const Ball_network::Edge &a = graph_.edges[e], &b = graph_.edges[f];
    return std::tie(b.*width_, a.nodes) < std::tie(a.*width_, b.nodes);
  }

  void take_portion(std::size_t begin, std::size_t end, std::size_t number) {
    const auto less = [this](Index e, Index f) { return is_before(e, f); };
    const auto place = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    if(end < order_.size())
      std::nth_element(place(begin), place(end), order_.end(), less);
    sort(execution_, place(begin), place(end), less);
    names_.find(execution_, place(begin), place(end));
    std::vector<Closing> closing;
    for(std::size_t i = begin; i < end; ++i)
      if(const auto name = join(order_[i]); name != 0 && known_.insert(name).second) {
        known_.insert(0 - name);
        closing.push_back({order_[i], name});
      }
    if(!closing.empty())
      add_cycles(closing, number);
  }

  // Joins the ends of an edge. Returns the name of the cycle that it closes, 0 if it closes none.
  std::uint64_t join(Index edge) {
    const auto [a, b] = graph_.edges[edge].nodes;
    const auto around = joined_.join(a, b, names_[edge]);
    if(!around)
      forest_.push_back(edge);
    return around.value_or(0);
  }

  // ---- cycles of a portion

  /// The forest with a way to a root from each node.
  struct Rooted_forest
  {
    std::vector<Index> parent; // itself at a root
    std::vector<Index> depth;
  };

  Rooted_forest rooted() const {
    std::vector<std::size_t> begin(graph_.nodes.size() + 1, 0);
    for(Index e : forest_)
      for(Index v : graph_.edges[e].nodes)
        ++begin[v + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> neighbors(begin.back());
    std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
    for(Index e : forest_) {
      const auto [a, b] = graph_.edges[e].nodes;
      neighbors[end[a]++] = b;
      neighbors[end[b]++] = a;
    }
    Rooted_forest forest = {std::vector<Index>(graph_.nodes.size(), no_index),
                            std::vector<Index>(graph_.nodes.size(), 0)};
    std::vector<Index> queue;
    for(Index root = 0; root < forest.parent.size(); ++root) {
      if(forest.parent[root] != no_index)
        continue;
      forest.parent[root] = root;
      queue.assign(1, root);
      for(std::size_t i = 0; i < queue.size(); ++i)
        for(std::size_t k = begin[queue[i]]; k < begin[queue[i] + 1]; ++k)
          if(const Index v = neighbors[k]; forest.parent[v] == no_index) {
            forest.parent[v] = queue[i];
            forest.depth[v] = forest.depth[queue[i]] + 1;
            queue.push_back(v);
          }
    }
    return forest;
  }

  void add_cycles(const std::vector<Closing>& closing, std::size_t number) {
    const Rooted_forest forest = rooted();
    for(const Closing& c : closing) {
      if(cycles_.size() == number)
        return;
      Widest_cycle cycle = cycle_of(c.edge, forest);
      if(rank_.add(cycle.row))
        cycles_.push_back(std::move(cycle));
    }
  }

  Widest_cycle cycle_of(Index edge, const Rooted_forest& forest) const {
    const auto [a, b] = graph_.edges[edge].nodes;
    std::vector<Index> from_a(1, a), from_b(1, b);
    while(from_a.back() != from_b.back()) {
      std::vector<Index>& deeper =
          forest.depth[from_a.back()] > forest.depth[from_b.back()] ? from_a : from_b;
      deeper.push_back(forest.parent[deeper.back()]);
    }
    from_a.pop_back(); // from b to where they meet, and on to a
    from_b.insert(from_b.end(), from_a.rbegin(), from_a.rend());
    Widest_cycle cycle;
    cycle.radius = graph_.edges[edge].*width_;
    cycle.balls.push_back({graph_.narrowest(edge), cycle.radius});
    for(Index v : from_b)
      cycle.balls.push_back(graph_.nodes[v]);
    for(std::size_t i = 0; i < from_b.size(); ++i)
      names_.add(from_b[i], from_b[i + 1 < from_b.size() ? i + 1 : 0], cycle.row);
    add_up(cycle.row);
    return cycle;
  }

  Execution execution_;
  const Ball_network& graph_;
  Edge_names& names_;
  Width width_;
  std::vector<Index> order_;
  Named_forest joined_;
  std::vector<Index> forest_;
  std::unordered_set<std::uint64_t> known_; // names of cycles, either way around
  Linking_rank rank_;
  std::vector<Widest_cycle> cycles_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WIDEST_CYCLES_H
