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
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Closed walks of given classes: loops one after the other, each as often as it is asked for,
/// joined by paths with few edges, there and back. A workspace that can be used again.
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
    std::vector<std::vector<Index>> walks;
    for(const auto& [i, factor] : coordinates)
      walks.push_back(repeated(left_side(loops_[i], factor > 0), std::abs(factor)));
    while(walks.size() > 1)
      join_nearest(walks);
    remove_spurs(walks.front());
    return std::move(walks.front());
  }

private:
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

  static std::vector<Index> repeated(const std::vector<Index>& walk, std::int64_t number) {
    std::vector<Index> result;
    for(std::int64_t i = 0; i < number; ++i)
      result.insert(result.end(), walk.begin(), walk.end());
    return result;
  }

  // How a vertex is reached, and from which walk.
  struct Label
  {
    Index parent = no_index;
    Index walk = no_index;
  };

  // Where two walks meet: an edge, or a vertex that both pass.
  struct Meeting
  {
    Index u, v;
  };

  // Two walks that are nearest to each other become one, the last of them goes.
  void join_nearest(std::vector<std::vector<Index>>& walks) {
    const Meeting meeting = nearest(walks);
    std::vector<Index> way = way_back(meeting.u); // from u to a walk
    std::reverse(way.begin(), way.end());
    const std::vector<Index> other_way = way_back(meeting.v);
    if(meeting.u != meeting.v)
      way.insert(way.end(), other_way.begin(), other_way.end());
    const Index a = labels_[meeting.u].walk;
    const Index b = meeting.u != meeting.v ? labels_[meeting.v].walk : second_walk_;
    reset();
    splice(walks[a], way, walks[b]);
    walks.erase(walks.begin() + b);
  }

  // Leads a walk along a way that begins on it, around another walk at its end, and back.
  static void
  splice(std::vector<Index>& walk, const std::vector<Index>& way, std::vector<Index>& around) {
    std::rotate(around.begin(), std::find(around.begin(), around.end(), way.back()), around.end());
    std::vector<Index> detour(way.begin(), way.end() - 1);
    detour.insert(detour.end(), around.begin(), around.end());
    detour.insert(detour.end(), way.rbegin(), way.rend() - 1);
    walk.insert(std::find(walk.begin(), walk.end(), way.front()), detour.begin(), detour.end());
  }

  // By the number of edges: what is joined is pulled taut anyway.
  Meeting nearest(const std::vector<std::vector<Index>>& walks) {
    for(Index w = 0; w < walks.size(); ++w)
      for(Index v : walks[w]) {
        if(labels_[v].walk != no_index && labels_[v].walk != w) {
          second_walk_ = w;
          return {v, v};
        }
        if(labels_[v].walk == no_index)
          reach(v, {no_index, w});
      }
    for(std::size_t i = 0; i < reached_.size(); ++i) {
      const Index v = reached_[i];
      for(Index u : mesh_.ring(v))
        if(labels_[u].walk == no_index)
          reach(u, {v, labels_[v].walk});
        else if(labels_[u].walk != labels_[v].walk)
          return {u, v};
    }
    CGAL_assertion_msg(false, "the loops of a class lie on one component");
    return {no_index, no_index};
  }

  void reach(Index v, const Label& label) {
    reached_.push_back(v);
    labels_[v] = label;
  }

  std::vector<Index> way_back(Index v) const {
    std::vector<Index> way;
    for(; v != no_index; v = labels_[v].parent)
      way.push_back(v);
    return way;
  }

  void reset() {
    for(Index v : reached_)
      labels_[v] = Label();
    reached_.clear();
  }

  const Flat_mesh& mesh_;
  const std::vector<Crossing_loop>& loops_;
  std::vector<Label> labels_; // by vertex
  std::vector<Index> reached_;
  Index second_walk_ = no_index; // of two that have a vertex in common
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_SUM_H
