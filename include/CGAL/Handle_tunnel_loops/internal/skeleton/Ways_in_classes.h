// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_WAYS_IN_CLASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_WAYS_IN_CLASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Ways in a graph of balls that are told from each other by how they pass through the curtains of
loops: each has a name, a sum of numbers that are different for all loops.
*/
class Ways_in_classes
{
public:
  using Name = std::uint64_t;
  using Way = std::vector<Index>; ///< by balls

  Ways_in_classes(Execution execution,
                  const Ball_graph& graph,
                  const std::vector<std::vector<Vector>>& loops)
      : graph_(graph)
      , names_(graph.edges.size(), 0) {
    std::mt19937_64 random;
    keys_.resize(loops.size());
    for(Name& key : keys_)
      key = random();
    const Loop_curtains curtains(execution, loops);
    for_each_index(
        execution, names_.size(),
        [&](std::size_t e) {
          const auto& [a, b] = graph.edges[e];
          curtains.for_each_passage(graph.balls[a].centre, graph.balls[b].centre,
                                    [&](const Loop_curtains::Passage& p) {
                                      names_[e] += p.sign > 0 ? keys_[p.loop] : 0 - keys_[p.loop];
                                    });
        },
        1024);
  }

  /// that of a closed way which is linked once with a loop, and with no other, but for its sign.
  Name key(Index loop) const { return keys_[loop]; }

  Name name(const Way& way) const {
    Name sum = 0;
    for(std::size_t i = 1; i < way.size(); ++i)
      for(const Index e : graph_.edges_at[way[i]])
        if(graph_.other_end(e, way[i]) == way[i - 1]) {
          sum += name(e, way[i - 1]);
          break;
        }
    return sum;
  }

  /// the cheapest way with one of two names, by edges that cost `cost(edge, ball)` towards a ball,
  /// if that is not negative; an empty one if there is none, or it is not found in so many steps.
  template <typename Cost>
  Way find(Index from,
           Index to,
           const std::array<Name, 2>& names,
           const Cost& cost,
           std::size_t most_steps) const {
    using Entry = std::pair<double, Index>;
    std::vector<State> states = {{from, no_index, 0, 0.}};
    std::unordered_map<Name, Index> known = {{hash(from, 0), 0}};
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.push({0., 0});
    while(!queue.empty() && most_steps-- > 0) {
      const auto [distance, i] = queue.top();
      queue.pop();
      const State state = states[i];
      if(distance > state.distance)
        continue;
      if(state.ball == to && (state.name == names[0] || state.name == names[1]))
        return way_to(i, states);
      graph_.for_each_beside(state.ball, [&](Index other, Index e) {
        const double step = cost(e, other);
        if(step < 0.)
          return;
        const State next = {other, i, state.name + name(e, state.ball), distance + step};
        const auto [it, is_new] =
            known.try_emplace(hash(other, next.name), static_cast<Index>(states.size()));
        if(is_new)
          states.push_back(next);
        else if(next.distance < states[it->second].distance)
          states[it->second] = next;
        else
          return;
        queue.push({next.distance, it->second});
      });
    }
    return {};
  }

private:
  struct State
  {
    Index ball, before;
    Name name;
    double distance;
  };

  static Name hash(Index ball, Name name) {
    constexpr Name odd = 0x9e3779b97f4a7c15;
    return name * odd + ball;
  }

  // Along an edge from one of its balls to the other.
  Name name(Index edge, Index from) const {
    return graph_.edges[edge][0] == from ? names_[edge] : 0 - names_[edge];
  }

  static Way way_to(Index state, const std::vector<State>& states) {
    Way way;
    for(; state != no_index; state = states[state].before)
      way.push_back(states[state].ball);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const Ball_graph& graph_;
  std::vector<Name> keys_;  // by loop
  std::vector<Name> names_; // by edge, from its first ball to its second
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_WAYS_IN_CLASSES_H
