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

#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Voronoi_graph.h>
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
  std::vector<Voronoi_graph::Node> balls; ///< the first is the smallest
};

/*!
The widest closed walks of a Voronoi graph that are independent by their linking numbers.

Edges are taken in the order of falling radius (Kruskal). One that joins what is not yet joined
becomes one of a forest; another one closes a cycle with it, of which nothing but the linking
numbers matters. They are added up from the roots, as one random number first, by which most cycles
are found to be nothing new.

Edges come in portions, the widest first, until there are enough cycles.
*/
class Widest_cycles
{
public:
  Widest_cycles(Execution execution, const Voronoi_graph& graph, const Linked_segments& linked)
      : execution_(execution)
      , graph_(graph)
      , linked_(linked)
      , order_(graph.edges.size())
      , root_(graph.nodes.size())
      , name_to_root_(graph.nodes.size(), 0) {
    std::iota(order_.begin(), order_.end(), Index(0));
    std::iota(root_.begin(), root_.end(), Index(0));
  }

  /// that many, the widest first; fewer if there are not so many.
  std::vector<Widest_cycle> find(std::size_t number) {
    std::size_t begin = 0, size = order_.size() / 16 + 1024;
    while(cycles_.size() < number && begin < order_.size()) {
      const std::size_t end = (std::min)(begin + size, order_.size());
      take_portion(begin, end, number);
      begin = end;
      size *= 2;
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
    const Voronoi_graph::Edge &a = graph_.edges[e], &b = graph_.edges[f];
    return std::tie(b.radius, a.nodes) < std::tie(a.radius, b.nodes);
  }

  void take_portion(std::size_t begin, std::size_t end, std::size_t number) {
    const auto less = [this](Index e, Index f) { return is_before(e, f); };
    const auto place = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    if(end < order_.size())
      std::nth_element(place(begin), place(end), order_.end(), less);
    sort(execution_, place(begin), place(end), less);
    std::vector<std::uint64_t> names(end - begin);
    for_each_index(
        execution_, names.size(), [&](std::size_t i) { names[i] = name(order_[begin + i]); }, 1024);
    std::vector<Closing> closing;
    for(std::size_t i = begin; i < end; ++i)
      if(const auto name = join(order_[i], names[i - begin]);
         name != 0 && known_.insert(name).second) {
        known_.insert(0 - name);
        closing.push_back({order_[i], name});
      }
    if(!closing.empty())
      add_cycles(closing, number);
  }

  std::uint64_t name(Index edge) const {
    const auto [a, b] = graph_.edges[edge].nodes;
    return linked_.name(graph_.nodes[a].place, graph_.nodes[b].place);
  }

  // Joins the ends of an edge. Returns the name of the cycle that it closes, 0 if it closes none.
  std::uint64_t join(Index edge, std::uint64_t name) {
    const auto [a, b] = graph_.edges[edge].nodes;
    const auto [root_a, name_a] = find_root(a);
    const auto [root_b, name_b] = find_root(b);
    const std::uint64_t around = name_b + name - name_a; // from the root of b by b and a
    if(root_a == root_b)
      return around;
    forest_.push_back(edge);
    // From the root of a by a and b to that of b: name_a is of the way from a to its root.
    const Index child = (std::max)(root_a, root_b);
    root_[child] = (std::min)(root_a, root_b);
    name_to_root_[child] = child == root_a ? around : 0 - around;
    return 0;
  }

  // With the name of the way there. Halves the ways.
  std::pair<Index, std::uint64_t> find_root(Index v) {
    std::uint64_t name = 0;
    while(root_[v] != v) {
      const Index above = root_[v];
      if(root_[above] != above) {
        name_to_root_[v] += name_to_root_[above];
        root_[v] = root_[above];
      }
      name += name_to_root_[v];
      v = root_[v];
    }
    return {v, name};
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
    cycle.radius = graph_.edges[edge].radius;
    cycle.balls.push_back({narrowest(graph_.nodes[a], graph_.nodes[b]), cycle.radius});
    for(Index v : from_b)
      cycle.balls.push_back(graph_.nodes[v]);
    for(std::size_t i = 0; i < from_b.size(); ++i)
      linked_.add(graph_.nodes[from_b[i]].place,
                  graph_.nodes[from_b[i + 1 < from_b.size() ? i + 1 : 0]].place, cycle.row);
    add_up(cycle.row);
    return cycle;
  }

  // The point of an edge that is nearest to the points that the balls of both its ends pass.
  static Vector narrowest(const Voronoi_graph::Node& a, const Voronoi_graph::Node& b) {
    const Vector way = b.place - a.place;
    const double square = dot(way, way);
    const double ratio =
        square > 0. ? 0.5 * (square + (a.radius - b.radius) * (a.radius + b.radius)) / square : 0.;
    return a.place + (std::max)(0., (std::min)(1., ratio)) * way;
  }

  Execution execution_;
  const Voronoi_graph& graph_;
  const Linked_segments& linked_;
  std::vector<Index> order_;
  std::vector<Index> root_;                 // by node, on the way to its root
  std::vector<std::uint64_t> name_to_root_; // by node, of that way
  std::vector<Index> forest_;
  std::unordered_set<std::uint64_t> known_; // names of cycles, either way around
  Linking_rank rank_;
  std::vector<Widest_cycle> cycles_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WIDEST_CYCLES_H
