// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Class_vector.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Closed walks of given classes: loops one after the other, each as often as it is asked for,
/// joined by shortest paths on the edges, there and back. A workspace that can be used again.
class Loop_sum
{
public:
  Loop_sum(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : mesh_(mesh)
      , loops_(loops)
      , labels_(mesh.number_of_vertices()) {}

  /// a closed walk of the class with these coordinates in the loops, which lie on one component.
  std::vector<Index> walk(const Class_vector& coordinates) {
    CGAL_precondition(!coordinates.empty());
    std::vector<Term> open;
    for(const auto& [i, factor] : coordinates)
      open.push_back(
          {left_side(loops_[i], factor > 0), static_cast<std::size_t>(std::abs(factor))});
    std::vector<Index> sum = repeated(open.back(), 0);
    open.pop_back();
    while(!open.empty())
      join(sum, open);
    remove_spurs(sum);
    return sum;
  }

private:
  struct Term
  {
    std::vector<Index> walk;
    std::size_t number;
  };

  static std::vector<Index> left_side(const Crossing_loop& loop, bool forward) {
    std::vector<Index> walk;
    for(const Crossing& c : loop)
      if(walk.empty() || walk.back() != c.left)
        walk.push_back(c.left);
    while(walk.size() > 1 && walk.back() == walk.front())
      walk.pop_back();
    if(!forward)
      std::reverse(walk.begin(), walk.end());
    return walk;
  }

  // From place `first` back to it, without the last vertex.
  static std::vector<Index> repeated(const Term& term, std::size_t first) {
    std::vector<Index> walk;
    for(std::size_t i = 0; i < term.number * term.walk.size(); ++i)
      walk.push_back(term.walk[(first + i) % term.walk.size()]);
    return walk;
  }

  // Leads the walk around one of the open ones, the nearest.
  void join(std::vector<Index>& sum, std::vector<Term>& open) {
    for(std::size_t t = 0; t < open.size(); ++t)
      for(std::size_t i = 0; i < open[t].walk.size(); ++i)
        if(Label& label = touched(open[t].walk[i]); label.term == no_index) {
          label.term = static_cast<Index>(t);
          label.place = static_cast<Index>(i);
        }
    const std::vector<Index> way = shortest_way(sum); // from the goal to the walk
    const Index t = labels_[way.front()].term, place = labels_[way.front()].place;
    reset();
    std::vector<Index> detour(way.rbegin(), way.rend() - 1);
    const std::vector<Index> around = repeated(open[t], place);
    detour.insert(detour.end(), around.begin(), around.end());
    detour.insert(detour.end(), way.begin(), way.end() - 1);
    sum.insert(std::find(sum.begin(), sum.end(), way.back()), detour.begin(), detour.end());
    open.erase(open.begin() + t);
  }

  std::vector<Index> shortest_way(const std::vector<Index>& from) {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    for(Index v : from) {
      touched(v).distance = 0.;
      queue.push({0., v});
    }
    for(;;) {
      CGAL_assertion_msg(!queue.empty(), "loops of one component");
      const auto [distance, v] = queue.top();
      queue.pop();
      if(distance > labels_[v].distance)
        continue;
      if(labels_[v].term != no_index)
        return way_back(v);
      for(Index u : mesh_.ring(v)) {
        const double d = distance + mesh_.edge_length(u, v);
        if(d < labels_[u].distance) {
          Label& label = touched(u);
          label.distance = d;
          label.parent = v;
          queue.push({d, u});
        }
      }
    }
  }

  std::vector<Index> way_back(Index v) const {
    std::vector<Index> way;
    for(; v != no_index; v = labels_[v].parent)
      way.push_back(v);
    return way;
  }

  struct Label
  {
    double distance = std::numeric_limits<double>::infinity();
    Index parent = no_index;
    Index term = no_index, place = no_index; // of an open walk that passes here
    bool is_touched = false;
  };

  Label& touched(Index v) {
    if(!labels_[v].is_touched)
      touched_.push_back(v);
    labels_[v].is_touched = true;
    return labels_[v];
  }

  void reset() {
    for(Index v : touched_)
      labels_[v] = Label();
    touched_.clear();
  }

  const Flat_mesh& mesh_;
  const std::vector<Crossing_loop>& loops_;
  std::vector<Label> labels_; // by vertex
  std::vector<Index> touched_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SUM_H
