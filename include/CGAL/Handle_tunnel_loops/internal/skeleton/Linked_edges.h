// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LINKED_EDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LINKED_EDGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loops_across.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How the edges of a graph of balls pass through the curtains of loops of their component: the
/// numbers of a closed way add up to its linking numbers.
class Linked_edges
{
public:
  Linked_edges(Execution execution, const Ball_graph& graph, const Loops_across& across)
      : graph_(graph)
      , components_(across.components)
      , curtains_(execution, across.loops)
      , passages_(graph.edges.size())
      , names_(graph.edges.size(), 0)
      , first_(across.genus.size() + 1, 0) {
    for(const Index component : across.components)
      ++first_[component + 1];
    for(std::size_t c = 1; c < first_.size(); ++c)
      first_[c] += first_[c - 1];
    for_each_index(
        execution, passages_.size(),
        [&](std::size_t e) {
          for_each_passage(graph.edges[e][0], graph.edges[e][1],
                           [&](const Passage& p) { passages_[e].push_back(p); });
        },
        1024);
    find_names(across.loops.size());
  }

  std::size_t number_of_components() const { return first_.size() - 1; }
  /// the number of the loops of a component.
  std::size_t width(Index component) const { return first_[component + 1] - first_[component]; }

  /// adds the numbers of an edge, as it is passed from one of its balls, times a factor to a row of
  /// those of its component.
  void add(Index from, Index edge, int factor, std::vector<int>& row) const {
    const Index first = first_[graph_.component[from]];
    for(const Passage& p : passages_[edge])
      row[p.loop - first] += graph_.edges[edge][0] == from ? factor * p.sign : -factor * p.sign;
  }

  /// the same for a way by balls, all of which need not be joined by edges.
  void add(const std::vector<Index>& way, int factor, std::vector<int>& row) const {
    for(std::size_t i = 1; i < way.size(); ++i)
      if(const Index e = graph_.edge_between(way[i - 1], way[i]); e != no_index)
        add(way[i - 1], e, factor, row);
      else
        for_each_passage(way[i - 1], way[i], [&](const Passage& p) {
          row[p.loop - first_[graph_.component[way[0]]]] += factor * p.sign;
        });
  }

  const Loop_curtains& curtains() const { return curtains_; }

  /// numbers of edges that add up along closed ways to a number of their class, 0 - that of the
  /// same way back; of different classes different ones, almost surely. Those of edges are for the
  /// way from the smaller end.
  const std::vector<std::uint64_t>& names() const { return names_; }

  /// that of an edge as it is passed from one of its balls.
  std::uint64_t name_from(Index from, Index edge) const {
    return graph_.edges[edge][0] == from ? names_[edge] : 0 - names_[edge];
  }

private:
  using Passage = Loop_curtains::Passage;

  template <typename Function>
  void for_each_passage(Index from, Index to, const Function& f) const {
    curtains_.for_each_passage(graph_.balls[from].centre, graph_.balls[to].centre,
                               [&](const Passage& p) {
                                 if(components_[p.loop] == graph_.component[from])
                                   f(p);
                               });
  }

  void find_names(std::size_t number_of_loops) {
    std::mt19937_64 random;
    std::vector<std::uint64_t> key(number_of_loops);
    for(std::uint64_t& k : key)
      k = random();
    for(Index e = 0; e < names_.size(); ++e)
      for(const Passage& p : passages_[e])
        names_[e] += p.sign > 0 ? key[p.loop] : 0 - key[p.loop];
  }

  const Ball_graph& graph_;
  const std::vector<Index>& components_; // by loop
  Loop_curtains curtains_;
  std::vector<std::vector<Passage>> passages_; // by edge
  std::vector<std::uint64_t> names_;           // by edge
  std::vector<Index> first_;                   // by component, of its loops
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LINKED_EDGES_H
