// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_SIMPLIFICATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_SIMPLIFICATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An end of the part of an arc, or of a path of arcs, on which the means of the front are known.
struct Arc_end
{
  Float_point point = {0.f, 0.f, 0.f}; ///< the last mean, or the extremum
  float girth = 0.f;                   ///< the length of the front at the node
};

/// How large an arc or a path is: the lowest and the highest value on it, what of the surface
/// belongs to it, and its length.
struct Arc_extent
{
  double low = 0., high = 0.;
  double amount = 0.; ///< of vertices, or area, as is asked for
  Arc_end lower, upper;
  float length = 0.f;      ///< of the line of the means, without the ways to saddles at the ends
  bool has_points = false; ///< arcs that are too short have no means

  /// the length as a multiple of the radius of a circle as long as the front at an end.
  double slenderness(const Arc_end& base) const {
    constexpr double circle = 6.28318530717958648;
    return base.girth > 0. ? circle * length / base.girth : (std::numeric_limits<double>::max)();
  }
};

/*!
Takes leaves off a Reeb graph: an arc with an extremum at its end, together with that extremum and
the saddle at its other end, where the two other arcs become one. The smallest leaf goes first, as
long as it is small enough; leaves may grow meanwhile. Each step takes away one extremum and one
saddle, and no cycle is touched. A leaf on a saddle whose two other ends are one arc stays, as do
arcs between two extrema.
*/
class Reeb_simplification
{
public:
  /// A part of a path: an arc of the graph that is simplified, and whether it is passed downwards.
  struct Piece
  {
    Index arc;
    bool is_reversed;
  };

  /// What two or more arcs have become.
  struct Path
  {
    Index lower, upper; ///< nodes of the graph that is simplified
    std::vector<Piece> pieces;
  };

  /// how many paths there may be in all: each leaf that is taken off makes one, and takes away an
  /// extremum.
  static std::size_t largest_number_of_paths(const Flat_reeb_graph& graph) {
    return graph.arcs.size() + static_cast<std::size_t>(std::count_if(
                                   graph.nodes.begin(), graph.nodes.end(), [](const auto& node) {
                                     return node.kind != Node_kind::SADDLE;
                                   }));
  }

  Reeb_simplification(const Flat_reeb_graph& graph, std::vector<Arc_extent> extents)
      : graph_(graph)
      , extent_(std::move(extents))
      , arcs_at_(graph.nodes.size(), {no_index, no_index, no_index})
      , became_(graph.arcs.size()) {
    CGAL_precondition(extent_.size() == graph.arcs.size());
    const std::size_t number = largest_number_of_paths(graph);
    extent_.reserve(number);
    paths_.reserve(number);
    became_.reserve(number);
    std::iota(became_.begin(), became_.end(), Index(0));
    for(Index a = 0; a < graph.arcs.size(); ++a) {
      paths_.push_back({graph.arcs[a].lower, graph.arcs[a].upper, nothing, nothing});
      add_at(graph.arcs[a].lower, a);
      add_at(graph.arcs[a].upper, a);
    }
  }

  /// takes off the leaves of which `is_small(extent, base, node)` says so, for their end at the
  /// saddle and any of their nodes; those of smallest `size(extent)` first.
  template <typename Size, typename IsSmall> void run(const Size& size, const IsSmall& is_small) {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto push = [&](Index a) {
      if(is_leaf(a) && is_small(extent_[a], base_of(a), paths_[a].lower))
        queue.push({size(extent_[a]), a});
    };
    for(Index a = 0; a < graph_.arcs.size(); ++a)
      push(a);
    while(!queue.empty()) {
      const Index leaf = queue.top().second;
      queue.pop();
      if(became_[leaf] == leaf && is_leaf(leaf) && can_go(leaf))
        push(take_off(leaf));
    }
  }

  /// the paths that are left, and for each arc of the graph the number of the path that it has
  /// become a part of, or that the leaf it belonged to was taken off from.
  std::pair<std::vector<Path>, std::vector<Index>> result() {
    std::vector<Path> kept;
    std::vector<Index> number(paths_.size(), no_index);
    for(Index a = 0; a < paths_.size(); ++a)
      if(became_[a] == a) {
        number[a] = static_cast<Index>(kept.size());
        kept.push_back(flattened(a));
      }
    std::vector<Index> path_of_arc(graph_.arcs.size());
    for(Index a = 0; a < path_of_arc.size(); ++a)
      path_of_arc[a] = number[find(a)];
    return {std::move(kept), std::move(path_of_arc)};
  }

private:
  using Entry = std::pair<double, Index>;
  static constexpr Piece nothing = {no_index, false};

  // A path is an arc of the graph, or two paths one after the other.
  struct Joint
  {
    Index lower, upper;
    Piece first, second;
  };

  void add_at(Index node, Index arc) {
    const auto place = std::find(arcs_at_[node].begin(), arcs_at_[node].end(), no_index);
    CGAL_assertion_msg(place != arcs_at_[node].end(), "a node has three arcs at most");
    *place = arc;
  }

  bool is_extremum(Index node) const { return graph_.nodes[node].kind != Node_kind::SADDLE; }

  bool is_leaf(Index a) const {
    return is_extremum(paths_[a].lower) != is_extremum(paths_[a].upper);
  }

  Index saddle_of(Index leaf) const {
    return is_extremum(paths_[leaf].lower) ? paths_[leaf].upper : paths_[leaf].lower;
  }

  const Arc_end& base_of(Index leaf) const {
    return is_extremum(paths_[leaf].lower) ? extent_[leaf].upper : extent_[leaf].lower;
  }

  // The two arcs at the saddle of a leaf that are not the leaf.
  std::pair<Index, Index> others_at(Index saddle, Index leaf) {
    Index others[2], count = 0;
    for(Index a : arcs_at_[saddle])
      if(find(a) != leaf) {
        CGAL_assertion_msg(count < 2, "the leaf is at the saddle");
        others[count++] = find(a);
      }
    CGAL_assertion_msg(count == 2, "a saddle has three arcs");
    return {others[0], others[1]};
  }

  bool can_go(Index leaf) {
    const auto [a, b] = others_at(saddle_of(leaf), leaf);
    return a != b;
  }

  Index take_off(Index leaf) {
    const Index saddle = saddle_of(leaf);
    const auto [a, b] = others_at(saddle, leaf);
    const Index from = other_end(a, saddle), to = other_end(b, saddle);
    const Index path = static_cast<Index>(paths_.size());
    // From the saddle's point of view the first part is passed towards it, the second from it.
    const Piece first = {a, paths_[a].upper != saddle}, second = {b, paths_[b].lower != saddle};
    if(from <= to)
      paths_.push_back({from, to, first, second});
    else
      paths_.push_back({to, from, {b, !second.is_reversed}, {a, !first.is_reversed}});
    became_.push_back(path);
    became_[a] = became_[b] = became_[leaf] = path;
    extent_.push_back(joined(paths_.back().first, paths_.back().second, leaf));
    return path;
  }

  Index other_end(Index a, Index node) const {
    return paths_[a].lower == node ? paths_[a].upper : paths_[a].lower;
  }

  // The extent of two paths one after the other, and of the leaf that was between them.
  Arc_extent joined(Piece first, Piece second, Index leaf) const {
    Arc_extent a = directed(first), b = directed(second);
    Arc_extent sum;
    sum.low = (std::min)(a.low, b.low);
    sum.high = (std::max)(a.high, b.high);
    sum.amount = a.amount + b.amount + extent_[leaf].amount;
    sum.length = a.length + b.length;
    if(a.has_points && b.has_points)
      sum.length += static_cast<float>(norm(to_vector(b.lower.point) - to_vector(a.upper.point)));
    sum.has_points = a.has_points || b.has_points;
    sum.lower = {(a.has_points ? a : b).lower.point, a.lower.girth};
    sum.upper = {(b.has_points ? b : a).upper.point, b.upper.girth};
    return sum;
  }

  Arc_extent directed(Piece piece) const {
    Arc_extent extent = extent_[piece.arc];
    if(piece.is_reversed)
      std::swap(extent.lower, extent.upper);
    return extent;
  }

  Index find(Index a) {
    while(became_[a] != a)
      a = became_[a] = became_[became_[a]];
    return a;
  }

  Path flattened(Index a) const {
    Path path = {paths_[a].lower, paths_[a].upper, {}};
    std::vector<Piece> stack(1, {a, false});
    while(!stack.empty()) {
      const Piece top = stack.back();
      stack.pop_back();
      const Joint& joint = paths_[top.arc];
      if(joint.first.arc == no_index) {
        path.pieces.push_back(top);
        continue;
      }
      const Piece first = {joint.first.arc, joint.first.is_reversed != top.is_reversed};
      const Piece second = {joint.second.arc, joint.second.is_reversed != top.is_reversed};
      stack.push_back(top.is_reversed ? first : second);
      stack.push_back(top.is_reversed ? second : first);
    }
    return path;
  }

  const Flat_reeb_graph& graph_;
  std::vector<Arc_extent> extent_;            // by path
  std::vector<Joint> paths_;                  // first the arcs of the graph
  std::vector<std::array<Index, 3>> arcs_at_; // by node, arcs of the graph
  std::vector<Index> became_;                 // by path, one that it became a part of
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_REEB_SIMPLIFICATION_H
