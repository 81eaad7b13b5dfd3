// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LIMBS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LIMBS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the limbs of a solid: parts that reach far out from the cycles of its skeleton, or from its
largest ball.

How far a place on the surface is from there is measured inside, along cheapest paths. The places
that are farther than some distance fall apart into regions, which join as the distance falls. A
region is a limb, where it joins one that reaches farther, if it is long against its mean girth.
*/
class Limbs
{
public:
  Limbs(const Ball_graph& graph,
        const Surface_samples& samples,
        const std::vector<std::pair<Index, Index>>& neighbors,
        double shortest_limb)
      : graph_(graph)
      , samples_(samples)
      , areas_(samples.areas())
      , shortest_limb_(shortest_limb)
      , paths_(graph.balls.size())
      , reach_(samples.samples().size())
      , is_beyond_(samples.samples().size(), 0)
      , neighbors_(neighbors)
      , edges_at_(samples.samples().size(), neighbors)
      , visit_(samples.samples().size(), 0) {}

  /// takes the edges to the ends of limbs, and to other ends that are given. \p roots are balls
  /// that the skeleton has even if it has no edges there.
  void add(const std::vector<Index>& roots,
           const std::vector<Index>& ends,
           double least_length,
           std::vector<char>& is_taken) {
    find_paths(roots, is_taken, [&](Index e) { return graph_.length(e); });
    for(Index s = 0; s < reach_.size(); ++s) {
      const Index b = graph_.ball_of_sample[s];
      reach_[s] = paths_[b].distance + norm(samples_.place(s) - graph_.balls[b].centre);
      is_beyond_[s] =
          paths_[b].start != no_index && paths_[b].distance > graph_.balls[paths_[b].start].radius;
    }
    make_even();
    find_paths(roots, is_taken, [&](Index e) { return Inner_cycles::cost(graph_, e); });
    const std::vector<Index> tips_of_limbs = tips(least_length);
    for(Index end : ends)
      take(end, is_taken);
    for(Index tip : tips_of_limbs)
      take(graph_.ball_of_sample[tip], is_taken);
  }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index, start = no_index;
  };

  template <typename Function> void for_each_beside(Index sample, const Function& f) const {
    for(Index i : edges_at_[sample]) {
      const auto& [a, b] = neighbors_[i];
      f(a == sample ? b : a);
    }
  }

  // Takes means: ways along edges are longer in some directions than in others, by which in thin
  // plates places would reach farther than all around them that don't.
  void make_even() {
    constexpr int number_of_rounds = 2;
    std::vector<double> means(reach_.size());
    for(int round = 0; round < number_of_rounds; ++round) {
      for(Index s = 0; s < reach_.size(); ++s) {
        double sum = reach_[s];
        for_each_beside(s, [&](Index other) { sum += reach_[other]; });
        means[s] = sum / double(1 + edges_at_[s].size());
      }
      reach_.swap(means);
    }
  }

  // From what is taken already and the roots.
  template <typename Cost>
  void
  find_paths(const std::vector<Index>& roots, const std::vector<char>& is_taken, const Cost& cost) {
    paths_.clear();
    start(roots, is_taken);
    grow(cost);
  }

  template <typename Cost> void grow(const Cost& cost) {
    graph_.grow(paths_, cost, [](const Label& before, double distance, Index e) {
      return Label{distance, e, before.start};
    });
  }

  void start(const std::vector<Index>& roots, const std::vector<char>& is_taken) {
    const auto begin = [&](Index b) {
      if(!paths_.is_reached(b))
        paths_.reach(b, {0., no_index, b});
    };
    std::vector<char> has_cycle(roots.size(), 0);
    for(Index e = 0; e < graph_.edges.size(); ++e)
      if(is_taken[e]) {
        has_cycle[graph_.component[graph_.edges[e][0]]] = 1;
        begin(graph_.edges[e][0]);
        begin(graph_.edges[e][1]);
      }
    for(std::size_t c = 0; c < roots.size(); ++c)
      if(!has_cycle[c] && roots[c] != no_index)
        begin(roots[c]);
  }

  // The samples at the ends of limbs.
  std::vector<Index> tips(double least_length) {
    std::vector<Index> order(reach_.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto is_farther = [&](Index a, Index b) {
      return std::tie(reach_[b], a) < std::tie(reach_[a], b);
    };
    std::sort(order.begin(), order.end(), is_farther);
    std::vector<Index> top(reach_.size(), no_index); // by representative
    std::vector<char> is_tip(reach_.size(), 0);
    Sets_of_indices sets(reach_.size());
    for(Index s : order) {
      if(!paths_.is_reached(graph_.ball_of_sample[s]))
        continue;
      top[s] = s;
      for_each_beside(s, [&](Index other) {
        if(top[other] == no_index)
          return;
        const Index a = sets.find(s), b = sets.find(other);
        if(a == b)
          return;
        const Index higher = is_farther(top[a], top[b]) ? top[a] : top[b],
                    lower = higher == top[a] ? top[b] : top[a];
        if(is_limb(lower, reach_[s], least_length))
          is_tip[lower] = is_tip[higher] = 1;
        sets.unite(a, b);
        top[sets.find(a)] = higher;
      });
    }
    for(Index s : order)
      if(sets.find(s) == s && top[s] != no_index && is_limb(top[s], 0., least_length))
        is_tip[top[s]] = 1;
    std::vector<Index> tips;
    for(Index s : order)
      if(is_tip[s])
        tips.push_back(s);
    return tips;
  }

  // Whether the region around the end of a limb is one, down to a distance.
  bool is_limb(Index tip, double level, double least_length) {
    const Index start = paths_[graph_.ball_of_sample[tip]].start;
    const double base = (std::max)(level, 1.1 * graph_.balls[start].radius);
    const double length = reach_[tip] - base;
    if(is_beyond_[tip] == 0 || !(length > least_length))
      return false;
    const double girth = area_beyond(tip, base) / length;
    constexpr double two_pi = 6.283185307179586;
    return length > shortest_limb_ * girth / two_pi;
  }

  double area_beyond(Index tip, double level) {
    ++number_of_visits_;
    double area = 0.;
    std::vector<Index> reached = {tip};
    visit_[tip] = number_of_visits_;
    for(std::size_t i = 0; i < reached.size(); ++i) {
      area += areas_[reached[i]];
      for_each_beside(reached[i], [&](Index s) {
        if(reach_[s] > level && visit_[s] != number_of_visits_) {
          visit_[s] = number_of_visits_;
          reached.push_back(s);
        }
      });
    }
    return area;
  }

  // Takes the way to a ball. Ways to others may go on from there.
  void take(Index ball, std::vector<char>& is_taken) {
    std::vector<Index> way = {ball};
    for(Index e = paths_[ball].edge; e != no_index; e = paths_[ball].edge) {
      is_taken[e] = 1;
      ball = graph_.other_end(e, ball);
      way.push_back(ball);
    }
    for(Index b : way)
      paths_.reach(b, {0., no_index, b});
    grow([&](Index e) { return Inner_cycles::cost(graph_, e); });
  }

  const Ball_graph& graph_;
  const Surface_samples& samples_;
  std::vector<double> areas_; // by sample
  double shortest_limb_;
  Shortest_paths<Label> paths_;
  std::vector<double> reach_;   // by sample
  std::vector<char> is_beyond_; // by sample, whether its ball lies outside of that where ways begin
  const std::vector<std::pair<Index, Index>>& neighbors_;
  Edges_at edges_at_;        // by sample, numbers of neighbours
  std::vector<Index> visit_; // by sample, the last one
  Index number_of_visits_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LIMBS_H
