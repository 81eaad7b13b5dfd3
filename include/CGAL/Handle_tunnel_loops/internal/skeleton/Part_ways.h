// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_WAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_WAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Linked_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds ways by the balls of a solid for arcs that stand for parts of its surface: the cheapest ones,
where balls that the part of the arc sees cost less than others. These take over where the part has
no way of its own inside.
*/
class Part_ways
{
public:
  using Way = Ways_of_arcs::Way;

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index;
  };

  struct Workspace
  {
    Shortest_paths<Label> paths;
    // By ball, the last arc near which it was, twice, and one more if the ball was its own.
    std::vector<Index> mark;
  };

public:
  Part_ways(const Ball_graph& balls, const Part_balls& part_balls, const Ways_of_arcs& drawn)
      : balls_(balls)
      , part_balls_(part_balls)
      , graph_(drawn.graph)
      , drawn_(drawn) {
    for(Index e = 0; e < balls.edges.size(); ++e)
      costs_.push_back(Inner_cycles::cost(balls, e));
  }

  Workspace_pool<Workspace> workspaces() const {
    return Workspace_pool<Workspace>([this] {
      return std::make_unique<Workspace>(
          Workspace{Shortest_paths<Label>(balls_.balls.size()),
                    std::vector<Index>(balls_.balls.size(), no_index)});
    });
  }

  /// the balls from the lower to the upper node; only these two if there is no way, and none if
  /// these have none.
  Way way(Index arc, Workspace& work) const {
    const Index from = drawn_.ball_of_node[graph_.arcs[arc][0]],
                to = drawn_.ball_of_node[graph_.arcs[arc][1]];
    if(from == no_index || to == no_index)
      return {};
    const bool is_cycle = graph_.arcs[arc][0] == graph_.arcs[arc][1];
    const Way straight = is_cycle ? Way{from} : cheapest_way(arc, from, to, work);
    if(!is_cycle && is_seen(arc, straight))
      return straight;
    for(const bool is_everywhere : {false, true}) {
      const Way by_part = way_by_part(arc, from, to, is_everywhere, work);
      if(by_part.size() > 1 && is_seen(arc, by_part))
        return by_part;
    }
    return straight;
  }

  /// the cheapest way that is good, of those by an edge and the cheapest ways to its ends: by balls
  /// of the arc and of those beside it if there is one, or else by any. Empty if there is none.
  /// Ways with the same name are asked for once.
  template <typename IsGood>
  Way other_way(Index arc, const Linked_edges& linked, const IsGood& is_good) const {
    Workspace work = {Shortest_paths<Label>(0), std::vector<Index>(balls_.balls.size(), no_index)};
    mark(arc, work.mark);
    std::unordered_set<std::uint64_t> known;
    for(const bool is_everywhere : {false, true}) {
      const auto cost_of = [&](Index e) {
        const auto [a, b] = balls_.edges[e];
        const bool is_free = is_everywhere || (work.mark[a] / 2 == arc && work.mark[b] / 2 == arc);
        return is_free ? 0.5 * (factor(a, arc, work) + factor(b, arc, work)) * cost(e)
                       : (std::numeric_limits<double>::infinity)();
      };
      const Named_paths there =
                            named_paths(drawn_.ball_of_node[graph_.arcs[arc][0]], linked, cost_of),
                        back =
                            named_paths(drawn_.ball_of_node[graph_.arcs[arc][1]], linked, cost_of);
      for(const auto& [distance, edge, from] : closing_edges(there, back, linked, cost_of, known))
        if(Way way = way_by(edge, from, there, back); is_good(way))
          return way;
    }
    return {};
  }

private:
  struct Named_label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index, ball = no_index;
    std::uint64_t name = 0; ///< of the way from where paths begin
  };
  using Named_paths = Shortest_paths<Named_label>;
  using Closing = std::tuple<double, Index, Index>; ///< how far, by which edge, from which ball

  template <typename Cost>
  Named_paths named_paths(Index from, const Linked_edges& linked, const Cost& cost_of) const {
    Named_paths paths(balls_.balls.size());
    paths.reach(from, {0., no_index, from, 0});
    balls_.grow(paths, cost_of, [&](const Named_label& label, double distance, Index e) {
      return Named_label{distance, e, balls_.other_end(e, label.ball),
                         label.name + linked.name_from(label.ball, e)};
    });
    return paths;
  }

  // One for each name that is not known, the cheapest first.
  template <typename Cost>
  std::vector<Closing> closing_edges(const Named_paths& there,
                                     const Named_paths& back,
                                     const Linked_edges& linked,
                                     const Cost& cost_of,
                                     std::unordered_set<std::uint64_t>& known) const {
    std::vector<std::pair<Closing, std::uint64_t>> all;
    for(const Index b : there.reached())
      balls_.for_each_beside(b, [&](Index other, Index e) {
        if(back.is_reached(other))
          all.push_back({{there[b].distance + cost_of(e) + back[other].distance, e, b},
                         there[b].name + linked.name_from(b, e) - back[other].name});
      });
    std::sort(all.begin(), all.end());
    std::vector<Closing> closing;
    for(const auto& [edge, name] : all)
      if(known.insert(name).second)
        closing.push_back(edge);
    return closing;
  }

  // From where paths begin to a ball, along an edge, and on to where others begin.
  Way way_by(Index edge, Index from, const Named_paths& there, const Named_paths& back) const {
    Way way = {from};
    balls_.for_each_back(there, from, [&](Index b, Index) { way.push_back(b); });
    std::reverse(way.begin(), way.end());
    way.push_back(balls_.other_end(edge, from));
    balls_.for_each_back(back, way.back(), [&](Index b, Index) { way.push_back(b); });
    return way;
  }

  // Marks the balls of an arc and of those beside it.
  void mark(Index arc, std::vector<Index>& marks) const {
    for(Index node : graph_.arcs[arc])
      for(Index beside : drawn_.arcs_at[node])
        part_balls_.for_each(beside, [&](Index b) { marks[b] = 2 * arc; });
    part_balls_.for_each(arc, [&](Index b) { marks[b] = 2 * arc + 1; });
  }

  // By which ways to a ball cost more, if it is not one of the arc.
  static double factor(Index ball, Index arc, const Workspace& work) {
    constexpr double penalty = 10.;
    return work.mark[ball] == 2 * arc + 1 ? 1. : penalty;
  }

  // Lets ways of an arc grow from a ball, as long as `goes_on(distance)`: by balls of the arc and
  // of those beside it, or also by all others.
  template <typename GoesOn, typename Cost>
  void grow(Index arc,
            Index from,
            bool is_everywhere,
            const GoesOn& goes_on,
            const Cost& cost_of,
            Workspace& work) const {
    mark(arc, work.mark);
    work.paths.clear();
    work.paths.reach(from, {0., no_index});
    work.paths.grow(goes_on, [&](Index b) {
      balls_.for_each_beside(b, [&](Index other, Index e) {
        if(!is_everywhere && work.mark[other] / 2 != arc)
          return;
        const double distance = work.paths[b].distance + factor(other, arc, work) * cost_of(e);
        if(distance < work.paths[other].distance)
          work.paths.reach(other, {distance, e});
      });
    });
  }

  double cost(Index edge) const { return costs_[edge]; }

  // From a ball to where ways began to grow.
  Way way_back(Index ball, const Workspace& work) const {
    Way way = {ball};
    balls_.for_each_back(work.paths, ball, [&](Index b, Index) { way.push_back(b); });
    return way;
  }

  // Whether the part of an arc sees a ball of a way.
  bool is_seen(Index arc, const Way& way) const {
    bool result = false;
    part_balls_.for_each(arc, [&](Index b) {
      result = result || std::find(way.begin(), way.end(), b) != way.end();
    });
    return result;
  }

  Way cheapest_way(Index arc, Index from, Index to, Workspace& work) const {
    if(from == to)
      return {from};
    for(const bool is_everywhere : {false, true}) {
      grow(
          arc, to, is_everywhere,
          [&](double distance) { return distance < work.paths[from].distance; },
          [this](Index e) { return cost(e); }, work);
      if(work.paths.is_reached(from))
        return way_back(from, work);
    }
    return {from, to};
  }

  // By way of a large ball of the arc that is far from where it begins, and on beside the way
  // there: for cycles, and for arcs of which the part is not between the nodes. Empty if there is
  // none.
  Way way_by_part(Index arc, Index from, Index to, bool is_everywhere, Workspace& work) const {
    const auto always = [](double) { return true; };
    grow(
        arc, from, is_everywhere, always, [this](Index e) { return balls_.length(e); }, work);
    const auto distance = [&](Index b) {
      return work.paths.is_reached(b) ? work.paths[b].distance : 0.;
    };
    constexpr double far_enough = 0.8;
    double most = 0.;
    part_balls_.for_each(arc, [&](Index b) { most = (std::max)(most, distance(b)); });
    Index farthest = from;
    part_balls_.for_each(arc, [&](Index b) {
      if(distance(b) > far_enough * most &&
         (farthest == from || balls_.balls[b].radius > balls_.balls[farthest].radius))
        farthest = b;
    });
    grow(
        arc, from, is_everywhere, always, [this](Index e) { return cost(e); }, work);
    Way there = way_back(farthest, work);
    std::reverse(there.begin(), there.end());
    constexpr double penalty = 10.;
    constexpr char unknown = 2;
    std::vector<char> is_beside(balls_.balls.size(), unknown);
    const auto is_end_beside = [&](Index end) {
      if(is_beside[end] == unknown)
        is_beside[end] = this->is_beside(there, end) ? 1 : 0;
      return is_beside[end] != 0;
    };
    grow(
        arc, to, is_everywhere, always,
        [&](Index e) {
          const auto [a, b] = balls_.edges[e];
          return (is_end_beside(a) && is_end_beside(b) ? penalty : 1.) * cost(e);
        },
        work);
    Way back = way_back(farthest, work);
    if(back.back() != to)
      return {};
    while(there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[1]) {
      there.pop_back();
      back.erase(back.begin());
    }
    there.insert(there.end(), back.begin() + 1, back.end());
    return there;
  }

  // Whether the centre of a ball is in one of a way.
  bool is_beside(const Way& way, Index ball) const {
    return std::any_of(way.begin(), way.end(), [&](Index b) {
      return norm(balls_.balls[b].centre - balls_.balls[ball].centre) < balls_.balls[b].radius;
    });
  }

  const Ball_graph& balls_;
  const Part_balls& part_balls_;
  const Graph_of_parts& graph_;
  const Ways_of_arcs& drawn_;
  std::vector<double> costs_; // by edge
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_WAYS_H
