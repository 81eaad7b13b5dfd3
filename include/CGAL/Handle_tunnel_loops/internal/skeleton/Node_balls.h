// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_NODE_BALLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_NODE_BALLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Linked_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Finds the balls that the nodes of a graph of parts are in.
class Node_balls
{
public:
  Node_balls(Execution execution,
             const Wall& wall,
             const Ball_graph& balls,
             const Linked_edges& linked,
             const Part_balls& part_balls,
             Ways_of_arcs& drawn)
      : execution_(execution)
      , wall_(wall)
      , balls_(balls)
      , linked_(linked)
      , part_balls_(part_balls)
      , graph_(drawn.graph)
      , drawn_(drawn) {}

  /// A node is where parts of several arcs meet, along a contour: from the ball of its vertex it
  /// goes to larger and larger ones that two of these see.
  void find() {
    for_each_index(
        execution_, drawn_.ball_of_node.size(),
        [&](std::size_t i) {
          const Index n = static_cast<Index>(i);
          drawn_.ball_of_node[n] = part_balls_.at_vertex(graph_.vertex_of_node[n]);
          if(drawn_.ball_of_node[n] != no_index && drawn_.arcs_at[n].size() > 1)
            drawn_.ball_of_node[n] =
                largest_ball_from(drawn_.ball_of_node[n], part_balls_.between(drawn_.arcs_at[n]));
        },
        16);
  }

  /// Where two of three ways begin side by side, the node goes to where they part, and the third
  /// one leads there.
  void move() {
    for(Index n = 0; n < drawn_.ball_of_node.size(); ++n) {
      const Span<const Index> arcs = drawn_.arcs_at[n];
      if(arcs.size() != 3 || drawn_.ball_of_node[n] == no_index)
        continue;
      std::array<Way, 3> ways;
      for(std::size_t i = 0; i < 3; ++i) {
        ways[i] = drawn_.from(n, arcs[i]);
        if(i > 0 && arcs[i] == arcs[i - 1]) // a cycle
          std::reverse(ways[i].begin(), ways[i].end());
      }
      if(arcs[0] == arcs[1] || arcs[1] == arcs[2])
        move_along_cycle(n, arcs[0] == arcs[1] ? 0 : 1, ways);
      else
        move_along_arcs(n, ways);
    }
  }

private:
  using Way = Ways_of_arcs::Way;

  Index largest_ball_from(Index ball, const std::vector<Index>& balls) const {
    for(Index before = no_index; before != ball;) {
      before = ball;
      balls_.for_each_beside(before, [&](Index other, Index) {
        if(balls_.balls[other].radius > balls_.balls[ball].radius &&
           std::binary_search(balls.begin(), balls.end(), other))
          ball = other;
      });
    }
    return ball;
  }

  // How far two ways that begin at the same ball run side by side, and not as far as to their ends:
  // the numbers of the last balls on both.
  std::pair<std::size_t, std::size_t> begin_in_common(const Way& a, const Way& b) const {
    constexpr double most = 0.5; // distance between centres, in the radius
    std::size_t i = 0, j = 0;
    const auto distance = [&](std::size_t k, std::size_t l) {
      if(k + 1 >= a.size() || l + 1 >= b.size())
        return most;
      const Inner_ball &p = balls_.balls[a[k]], &q = balls_.balls[b[l]];
      return norm(q.centre - p.centre) / (std::min)(p.radius, q.radius);
    };
    for(;;) {
      const double both = distance(i + 1, j + 1), first = distance(i + 1, j),
                   second = distance(i, j + 1);
      if(!((std::min)({both, first, second}) < most))
        return {i, j};
      i += both <= second || first <= second ? 1 : 0;
      j += both <= first || second < first ? 1 : 0;
    }
  }

  void move_along_arcs(Index node, std::array<Way, 3>& ways) {
    std::pair<std::size_t, std::size_t> most = {0, 0};
    std::size_t other = 0; // than those that begin side by side
    for(std::size_t i = 0; i < 3; ++i)
      if(const auto common = begin_in_common(ways[(i + 1) % 3], ways[(i + 2) % 3]);
         common.first + common.second > most.first + most.second)
      {
        most = common;
        other = i;
      }
    Way &a = ways[(other + 1) % 3], &b = ways[(other + 2) % 3];
    if(most.first + most.second == 0 || !are_side_by_side(a, most.first, b, most.second))
      return;
    lead_on(a, most.first, ways[other]);
    a.erase(a.begin(), a.begin() + std::ptrdiff_t(most.first));
    b.erase(b.begin(), b.begin() + std::ptrdiff_t(most.second));
    b.insert(b.begin(), a.front());
    for(std::size_t i = 0; i < 3; ++i)
      drawn_.set_from(node, drawn_.arcs_at[node][i], ways[i]);
    drawn_.ball_of_node[node] = a.front();
  }

  // The cycle is the arc with this number and the next one.
  void move_along_cycle(Index node, std::size_t first, std::array<Way, 3>& ways) {
    Way& cycle = ways[first];
    auto [i, j] = begin_in_common(cycle, ways[first + 1]);
    if(i + j == 0 || 2 * (i + j + 2) > cycle.size() ||
       !are_side_by_side(cycle, i, ways[first + 1], j))
      return;
    const std::size_t other = first == 0 ? 2 : 0;
    lead_on(cycle, i, ways[other]);
    cycle.erase(cycle.end() - std::ptrdiff_t(j), cycle.end());
    cycle.erase(cycle.begin(), cycle.begin() + std::ptrdiff_t(i));
    cycle.push_back(cycle.front());
    drawn_.ways[drawn_.arcs_at[node][first]] = cycle;
    drawn_.set_from(node, drawn_.arcs_at[node][other], ways[other]);
    drawn_.ball_of_node[node] = cycle.front();
  }

  // Whether one can go across from one way to another, and nothing that is linked with loops is in
  // between.
  bool are_side_by_side(const Way& a, std::size_t i, const Way& b, std::size_t j) const {
    if(a[i] != b[j] && wall_.meets(balls_.balls[a[i]].centre, balls_.balls[b[j]].centre))
      return false;
    std::vector<int> row(linked_.width(balls_.component[a[0]]), 0);
    Way across(a.begin(), a.begin() + std::ptrdiff_t(i) + 1);
    if(a[i] != b[j])
      across.push_back(b[j]);
    linked_.add(across, 1, row);
    linked_.add(Way(b.begin(), b.begin() + std::ptrdiff_t(j) + 1), -1, row);
    return std::all_of(row.begin(), row.end(), [](int x) { return x == 0; });
  }

  // Lets a way begin at a ball of another one, instead of where both begin.
  static void lead_on(const Way& along, std::size_t to, Way& way) {
    std::size_t from = 0; // where they part
    while(from < to && from + 1 < way.size() && along[from + 1] == way[from + 1])
      ++from;
    Way longer(along.begin() + std::ptrdiff_t(from), along.begin() + std::ptrdiff_t(to) + 1);
    std::reverse(longer.begin(), longer.end());
    longer.insert(longer.end(), way.begin() + std::ptrdiff_t(from) + 1, way.end());
    way = std::move(longer);
  }

  Execution execution_;
  const Wall& wall_;
  const Ball_graph& balls_;
  const Linked_edges& linked_;
  const Part_balls& part_balls_;
  const Graph_of_parts& graph_;
  Ways_of_arcs& drawn_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_NODE_BALLS_H
