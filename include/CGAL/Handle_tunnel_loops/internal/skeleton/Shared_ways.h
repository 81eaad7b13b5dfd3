// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SHARED_WAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SHARED_WAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Lets arcs of a skeleton share ways: two that leave a joint side by side become one until they part,
and a cycle that goes somewhere and back along itself stays away from there.

Arc by arc, the cheapest way is found between what is left without it, where ways along that are
free. It takes the place of the arc if it is cheaper and homologous to it, so that cycles stay a
basis. Classes are told by names of edges (`Inner_cycles::names()`), which add up along a way.
*/
class Shared_ways
{
public:
  Shared_ways(const Ball_graph& graph, const std::vector<std::uint64_t>& names)
      : graph_(graph)
      , names_(names)
      , along_(graph.balls.size())
      , paths_(graph.balls.size())
      , degree_(graph.balls.size())
      , is_taken_(graph.edges.size(), 0)
      , is_end_(graph.balls.size())
      , change_(graph.balls.size(), 0) {
    for(Index e = 0; e < graph.edges.size(); ++e)
      costs_.push_back(Inner_cycles::cost(graph, e));
  }

  /// can be called again after more has been taken, or less.
  void find(std::vector<char>& is_taken) {
    constexpr int most_rounds = 4;
    ++time_;
    for(Index e = 0; e < is_taken.size(); ++e)
      if(is_taken[e] != is_taken_[e]) {
        is_taken[e] != 0 ? take(e) : give_back(e);
        note_change(e);
      }
    for(Index b = 0; b < degree_.size(); ++b)
      is_end_[b] = degree_[b] == 1;
    for(int round = 0; round < most_rounds; ++round) {
      bool is_changed = false;
      for(const Arc& arc : arcs())
        if(is_whole(arc) && exchange(arc))
          is_changed = true;
      if(!is_changed)
        break;
    }
    is_taken = is_taken_;
  }

private:
  static constexpr double gain = 0.98; // of the cost, at most

  struct Arc
  {
    Index from, to;
    std::vector<Index> edges;
    double cost;
  };

  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index; // to the ball before
    bool is_of_end = false;
    std::uint64_t name = 0; // of the way from where the arc begins
  };

  struct Bridge
  {
    double cost = (std::numeric_limits<double>::infinity)();
    Index edge = no_index;
  };

  void count(Index edge, int number) {
    for(Index b : graph_.edges[edge])
      degree_[b] += static_cast<Index>(number);
  }
  void take(Index edge) {
    if(is_taken_[edge] == 0)
      count(edge, 1);
    is_taken_[edge] = 1;
  }
  void give_back(Index edge) {
    if(is_taken_[edge] != 0)
      count(edge, -1);
    is_taken_[edge] = 0;
  }

  void note_change(Index edge) {
    for(Index b : graph_.edges[edge])
      change_[b] = time_;
  }

  double cost(Index edge) const { return costs_[edge]; }
  // Of an edge as one leaves a ball by it.
  std::uint64_t name(Index edge, Index from) const {
    return graph_.edges[edge][0] == from ? names_[edge] : 0 - names_[edge];
  }

  // ---- arcs

  // The most expensive first; and halves of those that end near where they begin, of which one may
  // share its way with the other.
  std::vector<Arc> arcs() const {
    std::vector<Arc> arcs;
    std::vector<char> is_passed(is_taken_.size(), 0);
    const auto add_from = [&](Index ball) {
      graph_.for_each_beside(ball, [&](Index, Index e) {
        if(is_taken_[e] == 0 || is_passed[e] != 0)
          return;
        Arc arc = follow(ball, e, is_passed);
        const bool is_loop = arc.from == arc.to;
        if(!is_loop)
          arcs.push_back(arc);
        if(is_loop ? degree_[ball] > 2 : arc.edges.size() > 1 && comes_back(arc))
          arcs.push_back(cut_off_half(arc));
        else if(!is_loop)
          return;
        arcs.push_back(std::move(arc));
      });
    };
    for(Index b = 0; b < degree_.size(); ++b)
      if(degree_[b] > 0 && degree_[b] != 2)
        add_from(b);
    for(Index e = 0; e < is_taken_.size(); ++e)
      if(is_taken_[e] != 0 && is_passed[e] == 0)
        add_from(graph_.edges[e][0]);
    std::sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) {
      return std::tie(b.cost, a.edges) < std::tie(a.cost, b.edges);
    });
    return arcs;
  }

  bool comes_back(const Arc& arc) const {
    constexpr double part = 1. / 3.; // of the length, between the ends
    double length = 0.;
    for(Index e : arc.edges)
      length += graph_.length(e);
    return norm(graph_.balls[arc.to].centre - graph_.balls[arc.from].centre) < part * length;
  }

  Arc follow(Index from, Index edge, std::vector<char>& is_passed) const {
    Arc arc = {from, graph_.other_end(edge, from), {edge}, cost(edge)};
    is_passed[edge] = 1;
    while(degree_[arc.to] == 2 && arc.to != from) {
      Index next = no_index;
      graph_.for_each_beside(arc.to, [&](Index, Index e) {
        if(is_taken_[e] != 0 && e != arc.edges.back())
          next = e;
      });
      is_passed[next] = 1;
      arc.edges.push_back(next);
      arc.cost += cost(next);
      arc.to = graph_.other_end(next, arc.to);
    }
    return arc;
  }

  // The second half.
  Arc cut_off_half(Arc& arc) const {
    Arc half = {arc.to, arc.to, {}, 0.};
    while(half.edges.empty() || (half.cost < 0.5 * arc.cost && arc.edges.size() > 1)) {
      half.edges.push_back(arc.edges.back());
      half.cost += cost(arc.edges.back());
      half.from = graph_.other_end(arc.edges.back(), half.from);
      arc.edges.pop_back();
    }
    std::reverse(half.edges.begin(), half.edges.end());
    arc.to = half.from;
    arc.cost -= half.cost;
    return half;
  }

  // Whether an arc is still there and nothing else leaves it.
  bool is_whole(const Arc& arc) const {
    Index ball = arc.from;
    for(Index e : arc.edges) {
      if(is_taken_[e] == 0 || (ball != arc.from && degree_[ball] != 2))
        return false;
      ball = graph_.other_end(e, ball);
    }
    return true;
  }

  std::uint64_t name(const Arc& arc) const {
    std::uint64_t sum = 0;
    Index ball = arc.from;
    for(Index e : arc.edges) {
      sum += name(e, ball);
      ball = graph_.other_end(e, ball);
    }
    return sum;
  }

  // ---- exchanges

  bool exchange(const Arc& arc) {
    ++time_;
    if(arc.from == arc.to && degree_[arc.from] == 2)
      return exchange_cycle(arc);
    for(Index e : arc.edges)
      give_back(e);
    start(arc, name(arc), arc.cost);
    const std::vector<Index> way = is_known(arc) ? std::vector<Index>() : cheaper_way(arc.cost);
    for(Index e : way.empty() ? arc.edges : way)
      take(e);
    if(way.empty())
      return false;
    for(const std::vector<Index>& edges : {arc.edges, way})
      for(Index e : edges)
        note_change(e);
    for(Index end : {arc.from, arc.to})
      if(is_end_[end] == 0)
        trim(end);
    return true;
  }

  // Whether nothing has changed since an arc was examined, as far as one comes along what is taken.
  bool is_known(const Arc& arc) {
    const auto [front, back] = std::minmax(arc.edges.front(), arc.edges.back());
    const Index last = std::exchange(examinations_[{front, back}], time_);
    const auto is_old = [&](Index b) { return change_[b] < last; };
    const std::vector<Index>& there = along_.reached();
    return std::all_of(there.begin(), there.end(), is_old) &&
           std::all_of(arc.edges.begin(), arc.edges.end(), [&](Index e) {
             return is_old(graph_.edges[e][0]) && is_old(graph_.edges[e][1]);
           });
  }

  // A cycle without joints: from some of its places, the cheapest.
  bool exchange_cycle(const Arc& cycle) {
    constexpr std::size_t number = 8;
    along_.clear();
    if(is_known(cycle))
      return false;
    const std::uint64_t name_of_cycle = name(cycle);
    for(Index e : cycle.edges)
      give_back(e);
    std::vector<Index> best;
    double least = cycle.cost, sum = 0.;
    Index ball = cycle.from;
    std::size_t next = 0;
    for(Index e : cycle.edges) {
      if(sum * double(number) >= double(next) * cycle.cost) {
        ++next;
        start({ball, ball, {}, 0.}, name_of_cycle, least);
        std::vector<Index> way = cheaper_way(least);
        if(!way.empty()) {
          least = 0.;
          for(Index w : way)
            least += cost(w);
          best = std::move(way);
        }
      }
      sum += cost(e);
      ball = graph_.other_end(e, ball);
    }
    for(Index e : best.empty() ? cycle.edges : best)
      take(e);
    for(Index e : best) {
      note_change(e);
      for(Index b : graph_.edges[e])
        if(degree_[b] == 1)
          trim(b);
    }
    return !best.empty();
  }

  // The edges of a cheaper way between what begins at no cost, of the right class; none if there is
  // no such way.
  std::vector<Index> cheaper_way(double cost_of_arc) {
    Bridge best;
    best.cost = gain * cost_of_arc;
    if(class_ == 0)
      grow_from_smaller_side(cost_of_arc, best);
    else
      grow_from_all(cost_of_arc, best);
    if(best.edge == no_index)
      return {};
    std::vector<Index> way = {best.edge};
    for(const Index b : graph_.edges[best.edge])
      graph_.for_each_back(paths_, b, [&](Index, Index e) { way.push_back(e); });
    return way;
  }

  // The arc closes no cycle: only ways from one side of it to the other will do, and all of these
  // come to the smaller one.
  void grow_from_smaller_side(double cost_of_arc, Bridge& best) {
    const auto begins = [&](Index b) { return along_[b].distance < cost_of_arc; };
    std::array<std::size_t, 2> numbers = {0, 0};
    for(Index b : along_.reached())
      numbers[along_[b].is_of_end] += begins(b);
    const bool side = numbers[1] <= numbers[0];
    for(Index b : along_.reached())
      if(along_[b].is_of_end == side && begins(b))
        paths_.reach(b, {0., no_index, side, along_[b].name});
    paths_.grow([&](double distance) { return distance < best.cost; },
                [&](Index b) {
                  graph_.for_each_beside(b, [&](Index other, Index e) {
                    const double there = paths_[b].distance + cost(e);
                    if(is_taken_[e] != 0 || !(there < best.cost))
                      return;
                    const std::uint64_t n = paths_[b].name + name(e, b);
                    if(begins(other) && along_[other].is_of_end != side && along_[other].name == n)
                      best = {there, e};
                    if(degree_[other] == 0 && there < paths_[other].distance)
                      paths_.reach(other, {there, e, side, n});
                  });
                });
  }

  void grow_from_all(double cost_of_arc, Bridge& best) {
    for(Index b : along_.reached())
      if(along_[b].distance < cost_of_arc)
        paths_.reach(b, {0., no_index, along_[b].is_of_end, along_[b].name});
    paths_.grow(
        [&](double distance) { return 2. * distance < best.cost; },
        [&](Index b) {
          graph_.for_each_beside(b, [&](Index other, Index e) {
            if(is_taken_[e] != 0 || e == paths_[b].edge)
              return;
            const double there = paths_[b].distance + cost(e);
            // Of the other ball, the way does not change any more.
            if(paths_[other].distance <= paths_[b].distance && e != paths_[other].edge) {
              const double all = there + paths_[other].distance;
              const std::uint64_t around = paths_[b].name + name(e, b) - paths_[other].name;
              const bool is_same = paths_[b].is_of_end != paths_[other].is_of_end
                                       ? around == 0
                                       : around == class_ || around == 0 - class_;
              if(is_same && all < best.cost)
                best = {all, e};
            }
            // What else is taken is out of reach.
            if(degree_[other] == 0 && there < paths_[other].distance)
              paths_.reach(other, {there, e, paths_[b].is_of_end, paths_[b].name + name(e, b)});
          });
        });
  }

  // What is taken begins at no cost, as far from the ends of the arc as that is long. If the ends
  // meet there, the arc closes a cycle of a class.
  void start(const Arc& arc, std::uint64_t name_of_arc, double cost_of_arc) {
    along_.clear();
    paths_.clear();
    along_.reach(arc.from, {0., no_index, false, 0});
    class_ = arc.from == arc.to ? name_of_arc : 0;
    if(arc.to != arc.from)
      along_.reach(arc.to, {0., no_index, true, name_of_arc});
    along_.grow(
        [&](double distance) { return distance < cost_of_arc; },
        [&](Index b) {
          graph_.for_each_beside(b, [&](Index other, Index e) {
            if(is_taken_[e] == 0)
              return;
            const double there = along_[b].distance + cost(e);
            if(class_ == 0 && along_[other].distance <= along_[b].distance &&
               along_[other].is_of_end != along_[b].is_of_end)
              class_ = along_[b].name + name(e, b) - along_[other].name;
            if(there < along_[other].distance)
              along_.reach(other, {there, e, along_[b].is_of_end, along_[b].name + name(e, b)});
          });
        });
  }

  // Takes back what has become loose.
  void trim(Index ball) {
    while(degree_[ball] == 1) {
      Index edge = no_index;
      graph_.for_each_beside(ball, [&](Index, Index e) {
        if(is_taken_[e] != 0)
          edge = e;
      });
      give_back(edge);
      note_change(edge);
      ball = graph_.other_end(edge, ball);
    }
  }

  const Ball_graph& graph_;
  const std::vector<std::uint64_t>& names_;
  Shortest_paths<Label> along_, paths_;
  std::vector<double> costs_;  // by edge
  std::vector<Index> degree_;  // by ball
  std::vector<char> is_taken_; // by edge
  std::vector<char> is_end_;   // by ball
  std::uint64_t class_ = 0;    // of a cycle that an arc closes
  Index time_ = 0;
  std::vector<Index> change_;                             // by ball, when something there changed
  std::map<std::pair<Index, Index>, Index> examinations_; // of arcs, by their first and last edges
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SHARED_WAYS_H
