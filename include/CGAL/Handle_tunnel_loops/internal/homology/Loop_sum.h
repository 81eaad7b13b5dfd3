// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Level_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// how many edges loops cross, all together, each counted as often as its coordinate says.
inline double crossings_of_sum(const std::vector<Crossing_loop>& loops, const Class_vector& a) {
  double sum = 0.;
  for(const auto& [i, factor] : a)
    sum += std::abs(double(factor)) * double(loops[i].size());
  return sum;
}

/// Loops of given classes. A workspace that can be used again.
class Loop_sum
{
public:
  Loop_sum(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : mesh_(mesh)
      , loops_(loops)
      , labels_(mesh.number_of_vertices()) {}

  /// a loop of the class with these coordinates in the loops, which lie on one component: these one
  /// after the other, each as often as it is asked for, joined by paths with few edges, there and
  /// back; or if they cross very many edges, curves of their class that cross fewer, joined in this
  /// way.
  Crossing_loop loop(const Class_vector& coordinates) {
    CGAL_precondition(!coordinates.empty());
    walks_.clear();
    if(const std::vector<Crossing_loop> curves = fewer_crossings(coordinates); !curves.empty())
      for(const Crossing_loop& curve : curves)
        walks_.push_back(left_side(curve, true));
    else
      for(const auto& [i, factor] : coordinates)
        walks_.push_back(repeated(left_side(loops_[i], factor > 0), std::abs(factor)));
    join_all();
    std::vector<Index> all = std::move(walks_[joined(0)]);
    remove_spurs(all);
    return pushed_left(mesh_, all);
  }

private:
  // Curves of a class that cross half as many edges as the loops that it is the sum of; none, if
  // these do not cross so many that it is worth while to look for them.
  std::vector<Crossing_loop> fewer_crossings(const Class_vector& coordinates) const {
    constexpr double many = 4., part = 0.5;
    const double crossings = crossings_of_sum(loops_, coordinates);
    if(crossings < many * std::sqrt(double(mesh_.number_of_vertices())))
      return {};
    Level_curves level(mesh_, loops_, coordinates);
    return level.number_of_crossings() < part * crossings ? level.curves()
                                                          : std::vector<Crossing_loop>();
  }

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

  // The walks as a forest, whose trees are those that have been joined.
  struct Node
  {
    Index parent;
    Index height = 0;
  };

  // Joins walks where the regions meet that grow around them, the nearest to each other first: by
  // the number of edges, since what is joined is tightened anyway.
  void join_all() {
    nodes_.clear();
    for(Index w = 0; w < walks_.size(); ++w)
      nodes_.push_back({w});
    std::size_t parts = walks_.size();
    for(Index w = 0; w < walks_.size(); ++w)
      for(Index v : std::vector<Index>(walks_[w]))
        if(labels_[v].walk == no_index)
          reach(v, {no_index, w});
        else
          parts -= join(v, v, labels_[v].walk, w);
    for(std::size_t i = 0; parts > 1; ++i) {
      CGAL_assertion_msg(i < reached_.size(), "the loops of a class lie on one component");
      const Index v = reached_[i];
      for(Index u : mesh_.ring(v))
        if(labels_[u].walk == no_index)
          reach(u, {v, labels_[v].walk});
        else
          parts -= join(v, u, labels_[v].walk, labels_[u].walk);
    }
    for(Index v : reached_)
      labels_[v] = Label();
    reached_.clear();
  }

  // Joins the walks of which `a` and `b` have become parts, where `u` and `v` have been reached
  // from these. Returns whether they were two.
  bool join(Index u, Index v, Index a, Index b) {
    a = joined(a);
    b = joined(b);
    if(a == b)
      return false;
    std::vector<Index> way = way_back(u); // to a walk
    std::reverse(way.begin(), way.end());
    if(u != v) {
      const std::vector<Index> other_way = way_back(v);
      way.insert(way.end(), other_way.begin(), other_way.end());
    }
    if(nodes_[a].height <= nodes_[b].height) {
      std::swap(a, b);
      std::reverse(way.begin(), way.end());
    }
    nodes_[b].parent = a;
    nodes_[a].height = (std::max)(nodes_[a].height, nodes_[b].height + 1);
    splice(walks_[a], way, walks_[b]);
    return true;
  }

  // The walk that has become the one of all in its tree.
  Index joined(Index w) const {
    while(nodes_[w].parent != w)
      w = nodes_[w].parent;
    return w;
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

  const Flat_mesh& mesh_;
  const std::vector<Crossing_loop>& loops_;
  std::vector<Label> labels_; // by vertex
  std::vector<Index> reached_;
  std::vector<std::vector<Index>> walks_; // those that have been joined are at the root
  std::vector<Node> nodes_;               // by walk
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_SUM_H
