// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_BRIDGE_ARCS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_BRIDGE_ARCS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_embedding.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The arcs of a Reeb graph without which it falls apart: a contour on such an arc separates the
/// surface, and one on any other does not. And how much lies on either side of them.
class Bridge_arcs
{
public:
  /// \p weights are those of the arcs.
  Bridge_arcs(const Flat_reeb_graph& graph, const std::vector<double>& weights)
      : graph_(graph)
      , weights_(weights)
      , arcs_at_(graph.nodes.size(),
                 [&](const auto& f) {
                   for(Index a = 0; a < graph.arcs.size(); ++a)
                     for(const Index node : {graph.arcs[a].lower, graph.arcs[a].upper})
                       f(node, a);
                 })
      , number_(graph.nodes.size(), 0)
      , lowest_reached_(graph.nodes.size(), 0)
      , weight_(graph.nodes.size(), 0.)
      , is_bridge_(graph.arcs.size(), 0)
      , is_upper_beyond_(graph.arcs.size(), 0)
      , below_(graph.arcs.size(), 0.)
      , total_(graph.arcs.size(), 0.) {
    for(Index root = 0; root < graph.nodes.size(); ++root)
      if(number_[root] == 0)
        search(root);
  }

  bool is_bridge(Index arc) const { return is_bridge_[arc] != 0; }

  /// the weight of the side of the lower node, without the arc itself.
  double below(Index arc) const { return below_[arc]; }

  /// the weight of the component.
  double total(Index arc) const { return total_[arc]; }

  /// the arcs at a node.
  Span<const Index> arcs_at(Index node) const {
    return {arcs_at_.items.data() + arcs_at_.begin[node],
            arcs_at_.begin[node + 1] - arcs_at_.begin[node]};
  }

private:
  struct Step
  {
    Index node;
    Index arc;        ///< by which it was reached
    std::size_t next; ///< of its arcs
  };

  Index other_end(Index arc, Index node) const {
    const Flat_reeb_graph::Arc& a = graph_.arcs[arc];
    return a.lower == node ? a.upper : a.lower;
  }

  // Depth first. An arc by which a node is reached is a bridge if from there and further on no arc
  // leads back to a node before it.
  void search(Index root) {
    const std::size_t first_arc = visited_arcs_.size();
    steps_.push_back({root, no_index, 0});
    number_[root] = lowest_reached_[root] = ++count_;
    while(!steps_.empty()) {
      Step& step = steps_.back();
      if(step.next == arcs_at(step.node).size()) {
        leave(step);
        continue;
      }
      const Index arc = arcs_at(step.node)[step.next++];
      if(arc == step.arc)
        continue;
      const Index node = step.node, end = other_end(arc, node);
      if(number_[end] == 0) {
        number_[end] = lowest_reached_[end] = ++count_;
        steps_.push_back({end, arc, 0});
      } else if(number_[end] < number_[node]) {
        lowest_reached_[node] = (std::min)(lowest_reached_[node], number_[end]);
        weight_[node] += weights_[arc];
        visited_arcs_.push_back(arc);
      }
    }
    for(std::size_t i = first_arc; i < visited_arcs_.size(); ++i)
      finish(visited_arcs_[i], weight_[root]);
  }

  // All beyond the last node is known.
  void leave(const Step step) {
    steps_.pop_back();
    if(steps_.empty())
      return;
    const Index before = steps_.back().node;
    if(lowest_reached_[step.node] == number_[step.node]) {
      is_bridge_[step.arc] = 1;
      below_[step.arc] = weight_[step.node]; // of this side, see finish()
      is_upper_beyond_[step.arc] = graph_.arcs[step.arc].upper == step.node;
    }
    lowest_reached_[before] = (std::min)(lowest_reached_[before], lowest_reached_[step.node]);
    weight_[before] += weight_[step.node] + weights_[step.arc];
    visited_arcs_.push_back(step.arc);
  }

  void finish(Index arc, double total) {
    total_[arc] = total;
    if(is_upper_beyond_[arc] != 0)
      below_[arc] = total - below_[arc] - weights_[arc];
  }

  const Flat_reeb_graph& graph_;
  const std::vector<double>& weights_;
  Grouped<Index> arcs_at_;                     // by node
  std::vector<Index> number_, lowest_reached_; // by node, in the order of the search
  std::vector<double> weight_;                 // by node, beyond it
  std::vector<char> is_bridge_, is_upper_beyond_;
  std::vector<double> below_, total_;
  std::vector<Step> steps_;
  std::vector<Index> visited_arcs_;
  Index count_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_BRIDGE_ARCS_H
