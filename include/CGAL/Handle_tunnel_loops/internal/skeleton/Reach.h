// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_REACH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_REACH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the balls at edges that are taken; in components without such edges, the roots.
inline std::vector<Index> balls_of_skeleton(const Ball_graph& graph,
                                            const std::vector<Index>& roots,
                                            const std::vector<char>& is_taken) {
  std::vector<Index> balls = graph.roots_without_edges(roots, is_taken);
  for(Index e = 0; e < graph.edges.size(); ++e)
    if(is_taken[e])
      balls.insert(balls.end(), graph.edges[e].begin(), graph.edges[e].end());
  std::sort(balls.begin(), balls.end());
  balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
  return balls;
}

/// pairs of numbers, sorted, of which those in two ranges are each there once.
inline std::vector<std::pair<Index, Index>>
united(std::vector<std::pair<Index, Index>> pairs,
       const std::vector<std::pair<Index, Index>>& more) {
  pairs.insert(pairs.end(), more.begin(), more.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/*!
How far the samples of a surface are from given balls inside.

Balls are beside each other if they are in the graph, or if regions of their samples meet: in thin
plates with a bend the segment between these may not be inside. Ways along such pairs turn from side
to side, in some directions more than in others, and by way of the middle of long regions. So they
are measured straight, as far back as the balls that they pass are not far off the line.
*/
class Reach
{
public:
  /// \p neighbors are pairs of samples.
  Reach(const Ball_graph& graph,
        const Surface_samples& samples,
        const std::vector<std::pair<Index, Index>>& neighbors,
        const std::vector<Index>& from)
      : graph_(graph)
      , pairs_(united(pairs_of_edges(), pairs_of_neighbors(united(neighbors, graph.opposites))))
      , pairs_at_(graph.balls.size(), pairs_)
      , extents_(graph.balls.size())
      , paths_(graph.balls.size()) {
    find_extents();
    for(Index b : from)
      paths_.reach(b, {0., no_index, b});
    grow();
    for(Index s = 0; s < samples.samples().size(); ++s) {
      distances_.push_back(straight_distance(graph.ball_of_sample[s], samples.place(s)));
    }
    make_even(neighbors);
  }

  /// infinite if there is no way.
  double operator[](Index sample) const { return distances_[sample]; }
  std::size_t size() const { return distances_.size(); }

  /// about how far the regions of the ball of a sample extend.
  double extent(Index sample) const { return extents_[graph_.ball_of_sample[sample]]; }
  /// how far what a way to a sample begins in extends there, if there is a way: the radius of the
  /// ball, or of the round plate that is as broad where it is in the middle of a sheet.
  double extent_at_start(Index sample) const {
    constexpr double least_breadth = 2.; // of sheets, in radii
    const Index start = paths_[graph_.ball_of_sample[sample]].start;
    const double radius = graph_.balls[start].radius;
    return (std::max)(radius, graph_.breadth(start) - least_breadth * radius);
  }
  /// whether the ball of a sample is outside of that where the way begins.
  bool is_beyond_start(Index sample) const {
    const Label& label = paths_[graph_.ball_of_sample[sample]];
    return label.start != no_index && label.distance > graph_.balls[label.start].radius;
  }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index pair = no_index, start = no_index;
  };

  std::vector<std::pair<Index, Index>> pairs_of_edges() const {
    std::vector<std::pair<Index, Index>> pairs;
    for(const auto& [a, b] : graph_.edges)
      pairs.emplace_back(a, b);
    return pairs;
  }
  std::vector<std::pair<Index, Index>>
  pairs_of_neighbors(const std::vector<std::pair<Index, Index>>& neighbors) const {
    std::vector<std::pair<Index, Index>> pairs;
    for(const auto& [s, t] : neighbors) {
      const auto [a, b] = std::minmax(graph_.ball_of_sample[s], graph_.ball_of_sample[t]);
      if(a != b)
        pairs.emplace_back(a, b);
    }
    return pairs;
  }

  const Vector& centre(Index ball) const { return graph_.balls[ball].centre; }

  void find_extents() {
    for(Index b = 0; b < extents_.size(); ++b)
      extents_[b] = graph_.balls[b].radius;
    for(const auto& [a, b] : pairs_) {
      const double length = norm(centre(b) - centre(a));
      extents_[a] = (std::max)(extents_[a], length);
      extents_[b] = (std::max)(extents_[b], length);
    }
  }

  Index other_end(Index pair, Index ball) const {
    return pairs_[pair].first == ball ? pairs_[pair].second : pairs_[pair].first;
  }

  void grow() {
    paths_.grow([&](Index b) {
      for(Index pair : pairs_at_[b]) {
        const Index other = other_end(pair, b);
        const double distance = straight_distance(b, centre(other));
        if(distance < paths_[other].distance)
          paths_.reach(other, {distance, pair, paths_[b].start});
      }
    });
  }

  // To a place, by way of the ball before it.
  double straight_distance(Index before, const Vector& place) const {
    constexpr std::size_t most_steps = 6;
    std::array<Index, most_steps> way;
    way[0] = before;
    double least = paths_[before].distance + norm(place - centre(before));
    for(std::size_t n = 1; n < most_steps && paths_[way[n - 1]].pair != no_index; ++n) {
      way[n] = other_end(paths_[way[n - 1]].pair, way[n - 1]);
      const Vector line = place - centre(way[n]);
      for(std::size_t k = 0; k < n; ++k)
        if(!is_beside(way[k], centre(way[n]), line))
          return least;
      least = (std::min)(least, paths_[way[n]].distance + norm(line));
    }
    return least;
  }

  bool is_beside(Index ball, const Vector& from, const Vector& line) const {
    const Vector off = centre(ball) - from;
    const double square = dot(line, line), along = dot(off, line);
    return square * (dot(off, off) - extents_[ball] * extents_[ball]) < along * along;
  }

  // Takes means.
  void make_even(const std::vector<std::pair<Index, Index>>& neighbors) {
    constexpr int number_of_rounds = 2;
    std::vector<double> sums;
    std::vector<Index> numbers(distances_.size(), 1);
    for(const auto& [s, t] : neighbors) {
      ++numbers[s];
      ++numbers[t];
    }
    for(int round = 0; round < number_of_rounds; ++round) {
      sums = distances_;
      for(const auto& [s, t] : neighbors) {
        sums[s] += distances_[t];
        sums[t] += distances_[s];
      }
      for(std::size_t s = 0; s < sums.size(); ++s)
        distances_[s] = sums[s] / double(numbers[s]);
    }
  }

  const Ball_graph& graph_;
  std::vector<std::pair<Index, Index>> pairs_; // of balls
  Edges_at pairs_at_;                          // by ball
  std::vector<double> extents_;                // by ball
  Shortest_paths<Label> paths_;
  std::vector<double> distances_; // by sample
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_REACH_H
