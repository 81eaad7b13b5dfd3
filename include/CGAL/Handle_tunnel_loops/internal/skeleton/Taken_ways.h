// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_TAKEN_WAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_TAKEN_WAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inlet_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Limbs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loops_across.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Shared_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The edges of a graph of balls that a skeleton consists of: cycles that are a basis, the ways to
/// inlets and to the ends of limbs, as far as they go by themselves.
class Taken_ways
{
public:
  Taken_ways(Execution execution,
             const Solid_balls& solid,
             const Loops_across& across,
             double shortest_limb)
      : execution_(execution)
      , graph_(solid.graph()) {
    const std::vector<Index> inlets =
        Inlet_ways(solid.mesh(), solid.points(), solid.wall(), solid.pieces(), solid.samples())
            .add(graph_);
    take_cycles(solid, across);
    Shared_ways shared_ways(graph_, names_);
    shared_ways.find(is_taken_);
    constexpr int most_rounds = 3;
    const double least_length = part_of_diagonal * solid.diagonal();
    for(int round = 0; round < most_rounds; ++round) {
      Limbs limbs(graph_, solid.samples(), solid.neighbors(), roots_, is_taken_);
      if(round == 0)
        limbs.add(inlets, shortest_limb, least_length, is_taken_);
      if(!limbs.add_ends(shortest_limb, least_length, is_taken_))
        break;
    }
    shared_ways.find(is_taken_);
  }

  const Ball_graph& graph() const { return graph_; }
  /// by edge.
  const std::vector<char>& is_taken() const { return is_taken_; }
  /// a ball of each component.
  const std::vector<Index>& roots() const { return roots_; }

private:
  static constexpr double part_of_diagonal = 0.025; // of the shortest limbs

  void take_cycles(const Solid_balls& solid, const Loops_across& across) {
    const auto choose = [&] {
      const Inner_cycles cycles(execution_, graph_, across);
      is_taken_ = cycles.is_taken();
      roots_ = cycles.roots();
      names_ = cycles.names();
      return cycles.number_of_missing_cycles();
    };
    add_missing_ways(solid, graph_, choose);
    prune();
  }

  // Takes back what leads to no cycle.
  void prune() {
    std::vector<Index> degree(graph_.balls.size(), 0), ends;
    for(Index e = 0; e < graph_.edges.size(); ++e)
      if(is_taken_[e])
        for(Index b : graph_.edges[e])
          ++degree[b];
    for(Index b = 0; b < degree.size(); ++b)
      if(degree[b] == 1)
        ends.push_back(b);
    while(!ends.empty()) {
      const Index b = ends.back();
      ends.pop_back();
      graph_.for_each_beside(b, [&](Index other, Index e) {
        if(is_taken_[e] == 0)
          return;
        is_taken_[e] = 0;
        --degree[b];
        if(--degree[other] == 1)
          ends.push_back(other);
      });
    }
  }

  Execution execution_;
  Ball_graph graph_;
  std::vector<char> is_taken_;       // by edge
  std::vector<Index> roots_;         // by component
  std::vector<std::uint64_t> names_; // by edge
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_TAKEN_WAYS_H
