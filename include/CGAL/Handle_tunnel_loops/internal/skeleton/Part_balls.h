// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_BALLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_BALLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The balls that parts of a surface see.
class Part_balls
{
public:
  /// \p balls is the graph of those of the solid. All must outlive it.
  Part_balls(const Solid_balls& solid, const Ball_graph& balls, const Graph_of_parts& graph)
      : solid_(solid)
      , balls_(balls)
      , graph_(graph)
      , is_connected_(connected_balls()) {
    find_balls_of_arcs();
  }

  template <typename Function> void for_each(Index arc, const Function& f) const {
    for(Index i = first_ball_[arc]; i < first_ball_[arc + 1]; ++i)
      f(balls_of_arcs_[i]);
  }

  /// how many there are.
  std::size_t number(Index arc) const { return first_ball_[arc + 1] - first_ball_[arc]; }

  /// the ball that a vertex sees, or a vertex nearby if it has none; `no_index` if there is none at
  /// all.
  Index at_vertex(Index v) const {
    std::vector<Index> reached = {v};
    std::unordered_set<Index> is_reached = {v};
    for(std::size_t i = 0; i < reached.size(); ++i) {
      if(const Index b = ball_seen_from(reached[i]); b != no_index && is_connected_[b] != 0)
        return b;
      for(const Index u : solid_.mesh().ring(reached[i]))
        if(is_reached.insert(u).second)
          reached.push_back(u);
    }
    return no_index;
  }

  /// those that parts of two arcs see, sorted.
  std::vector<Index> between(Span<const Index> arcs) const {
    std::vector<Index> all, some;
    for(const Index arc : arcs)
      for_each(arc, [&](Index b) { all.push_back(b); });
    std::sort(all.begin(), all.end());
    for(std::size_t i = 1; i < all.size(); ++i)
      if(all[i] == all[i - 1] && (some.empty() || some.back() != all[i]))
        some.push_back(all[i]);
    return some;
  }

private:
  // By ball, whether it is connected with most balls of its component of the mesh: a few are not
  // where walls are thinner than doubles can tell.
  std::vector<char> connected_balls() const {
    Sets_of_indices sets(balls_.balls.size());
    for(const auto& [a, b] : balls_.edges)
      sets.unite(a, b);
    std::vector<Index> size(balls_.balls.size(), 0), largest; // by first ball, by component
    for(Index b = 0; b < size.size(); ++b) {
      const Index first = sets.find(b), component = balls_.component[b];
      ++size[first];
      if(component >= largest.size())
        largest.resize(component + 1, no_index);
      if(largest[component] == no_index || size[first] > size[largest[component]])
        largest[component] = first;
    }
    std::vector<char> is_connected(size.size());
    for(Index b = 0; b < size.size(); ++b)
      is_connected[b] = sets.find(b) == largest[balls_.component[b]];
    return is_connected;
  }

  Index ball_seen_from(Index v) const {
    const Index sample = solid_.mesh().is_hub(v) ? no_index : solid_.sample_at(v);
    return sample == no_index ? no_index : balls_.ball_of_sample[sample];
  }

  // Those that are seen from faces with a vertex of the arc.
  void find_balls_of_arcs() {
    const Surface_samples& samples = solid_.samples();
    std::vector<std::array<Index, 2>> pairs;
    for(Index s = 0; s < samples.samples().size(); ++s) {
      const Index f = solid_.pieces().face(samples.samples()[s].piece);
      for(Index v : solid_.wall()[f])
        if(const Index arc = graph_.arc_of_vertex[v]; arc != no_index)
          pairs.push_back({arc, balls_.ball_of_sample[s]});
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    first_ball_.assign(graph_.arcs.size() + 1, 0);
    for(const auto& [arc, ball] : pairs) {
      ++first_ball_[arc + 1];
      balls_of_arcs_.push_back(ball);
    }
    for(std::size_t a = 0; a < graph_.arcs.size(); ++a)
      first_ball_[a + 1] += first_ball_[a];
  }

  const Solid_balls& solid_;
  const Ball_graph& balls_;
  const Graph_of_parts& graph_;
  std::vector<char> is_connected_; // by ball
  std::vector<Index> first_ball_,
      balls_of_arcs_; // of each arc, those of the arcs one after another
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_BALLS_H
