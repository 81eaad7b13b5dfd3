// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_LINES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_LINES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_borders.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_in_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Arc_smoothing.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Draws a graph of parts of a surface in the middle of the solid.

A node is put into the ball that its vertex sees. The line of an arc is the cheapest way from ball
to ball, where balls that its own part of the surface sees cost less than others: these take over
where the part has no way of its own inside. Where two of the three lines at a node begin with the
same balls, the node goes to where they part. In the ball of a node lines are straight, and they are
smooth and in the middle from there on.
*/
class Part_lines
{
public:
  /// \p balls is the graph of those of the solid. All must outlive it.
  Part_lines(Execution execution,
             const Solid_balls& solid,
             const Ball_graph& balls,
             const Graph_of_parts& graph)
      : execution_(execution)
      , solid_(solid)
      , balls_(balls)
      , graph_(graph)
      , is_connected_(connected_balls())
      , ball_of_node_(graph.vertex_of_node.size())
      , ways_(graph.arcs.size())
      , arcs_at_(graph.vertex_of_node.size(), graph.arcs) {}

  Inner_drawing draw() {
    find_balls_of_arcs();
    place_nodes();
    find_ways();
    close_cycles();
    move_nodes();
    Inner_drawing drawing;
    drawing.nodes = places_of_nodes();
    drawing.lines.resize(graph_.arcs.size());
    for_each_index(
        execution_, drawing.lines.size(),
        [&](std::size_t a) { drawing.lines[a] = line(static_cast<Index>(a), drawing.nodes); }, 4);
    return drawing;
  }

private:
  using Balls = std::vector<Inner_ball>;

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

  static constexpr double within = 0.9; // of the radius of the ball of a node

  // ---- balls

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

  // The ball that a vertex sees, or a vertex nearby if it has none; `no_index` if there is none at
  // all.
  Index ball_of_vertex(Index v) const {
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

  // ---- ways

  Workspace_pool<Workspace> workspaces() const {
    return Workspace_pool<Workspace>([this] {
      return std::make_unique<Workspace>(
          Workspace{Shortest_paths<Label>(balls_.balls.size()),
                    std::vector<Index>(balls_.balls.size(), no_index)});
    });
  }

  template <typename Function> void for_each_ball(Index arc, const Function& f) const {
    for(Index i = first_ball_[arc]; i < first_ball_[arc + 1]; ++i)
      f(balls_of_arcs_[i]);
  }

  // Marks the balls of an arc and of those beside it.
  void mark(Index arc, std::vector<Index>& marks) const {
    for(Index node : graph_.arcs[arc])
      for(Index beside : arcs_at_[node])
        for_each_ball(beside, [&](Index b) { marks[b] = 2 * arc; });
    for_each_ball(arc, [&](Index b) { marks[b] = 2 * arc + 1; });
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

  double cost(Index edge) const { return Inner_cycles::cost(balls_, edge); }

  void find_ways() {
    auto pool = workspaces();
    for_each_index(
        execution_, ways_.size(),
        [&](std::size_t a) { ways_[a] = way(static_cast<Index>(a), *pool.borrow()); }, 16);
  }

  // The balls from the lower to the upper node; only these two if there is no way.
  std::vector<Index> way(Index arc, Workspace& work) const {
    const Index from = ball_of_node_[graph_.arcs[arc][0]], to = ball_of_node_[graph_.arcs[arc][1]];
    if(graph_.arcs[arc][0] == graph_.arcs[arc][1] && from != no_index) {
      std::vector<Index> around = way_around(arc, from, false, work);
      return around.size() > 1 ? around : way_around(arc, from, true, work);
    }
    if(from == to)
      return {from};
    if(from == no_index || to == no_index)
      return {from, to};
    for(const bool is_everywhere : {false, true}) {
      grow(
          arc, to, is_everywhere,
          [&](double distance) { return distance < work.paths[from].distance; },
          [this](Index e) { return cost(e); }, work);
      if(work.paths.is_reached(from))
        break;
    }
    return work.paths.is_reached(from) ? way_back(from, work) : std::vector<Index>{from, to};
  }

  // From a ball to where ways began to grow.
  std::vector<Index> way_back(Index ball, const Workspace& work) const {
    std::vector<Index> way = {ball};
    while(work.paths[ball].edge != no_index) {
      ball = balls_.other_end(work.paths[ball].edge, ball);
      way.push_back(ball);
    }
    return way;
  }

  // From the ball of a node back to it: by way of a large ball of the arc that is far away, and
  // back beside the way there.
  std::vector<Index>
  way_around(Index arc, Index node, bool is_everywhere, Workspace& work) const {
    const auto always = [](double) { return true; };
    grow(
        arc, node, is_everywhere, always, [this](Index e) { return balls_.length(e); }, work);
    const auto distance = [&](Index b) {
      return work.paths.is_reached(b) ? work.paths[b].distance : 0.;
    };
    constexpr double far_enough = 0.8;
    double most = 0.;
    for_each_ball(arc, [&](Index b) { most = (std::max)(most, distance(b)); });
    Index farthest = node;
    for_each_ball(arc, [&](Index b) {
      if(distance(b) > far_enough * most &&
         (farthest == node || balls_.balls[b].radius > balls_.balls[farthest].radius))
        farthest = b;
    });
    grow(
        arc, node, is_everywhere, always, [this](Index e) { return cost(e); }, work);
    std::vector<Index> there = way_back(farthest, work);
    std::reverse(there.begin(), there.end());
    constexpr double penalty = 10.;
    grow(
        arc, node, is_everywhere, always,
        [&](Index e) { return (is_beside(there, e) ? penalty : 1.) * cost(e); }, work);
    std::vector<Index> back = way_back(farthest, work);
    while(there.size() > 1 && back.size() > 1 && there[there.size() - 2] == back[1]) {
      there.pop_back();
      back.erase(back.begin());
    }
    there.insert(there.end(), back.begin() + 1, back.end());
    return there;
  }

  // Whether an edge begins and ends in balls of a way.
  bool is_beside(const std::vector<Index>& way, Index edge) const {
    const auto& ends = balls_.edges[edge];
    return std::all_of(ends.begin(), ends.end(), [&](Index end) {
      return std::any_of(way.begin(), way.end(), [&](Index b) {
        return norm(balls_.balls[b].centre - balls_.balls[end].centre) < balls_.balls[b].radius;
      });
    });
  }

  // ---- cycles

  // Arcs of a tree, those of large parts first.
  std::vector<char> arcs_of_tree() const {
    std::vector<Index> order(graph_.arcs.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto size = [this](Index arc) { return first_ball_[arc + 1] - first_ball_[arc]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return size(a) > size(b); });
    std::vector<char> is_in_tree(order.size(), 0);
    Sets_of_indices sets(graph_.vertex_of_node.size());
    for(const Index arc : order) {
      const auto [lower, upper] = graph_.arcs[arc];
      is_in_tree[arc] = sets.find(lower) != sets.find(upper);
      sets.unite(lower, upper);
    }
    return is_in_tree;
  }

  // Curves around those that are not of the tree.
  std::vector<Part_borders::Curve> borders_of_others(const std::vector<char>& is_in_tree) const {
    std::vector<Index> part_of_vertex = graph_.arc_of_vertex;
    for(Index v = solid_.mesh().first_hub; v < part_of_vertex.size(); ++v)
      part_of_vertex[v] = part_of_vertex[solid_.mesh().ring(v)[0]];
    std::vector<char> is_other(is_in_tree.size());
    for(std::size_t a = 0; a < is_other.size(); ++a)
      is_other[a] = is_in_tree[a] == 0;
    return Part_borders(solid_.mesh(), solid_.points(), part_of_vertex)(is_other);
  }

  // Each arc closes a cycle of the tree: this is to be linked with a border of the arc, and with
  // none of the other such arcs, if there is a way inside. There is none where the border bounds
  // outside.
  void close_cycles() {
    const std::vector<char> is_in_tree = arcs_of_tree();
    const std::vector<Part_borders::Curve> borders = borders_of_others(is_in_tree);
    const Ways_in_classes classes(execution_, balls_, borders);
    const std::vector<Ways_in_classes::Name> names = names_of_nodes(classes, is_in_tree);
    auto pool = workspaces();
    for_each_index(
        execution_, ways_.size(),
        [&](std::size_t i) {
          const Index arc = static_cast<Index>(i);
          const auto [lower, upper] = graph_.arcs[arc];
          if(borders[arc].empty() || ball_of_node_[lower] == no_index ||
             ball_of_node_[upper] == no_index)
            return;
          const Ways_in_classes::Name off = names[upper] - names[lower];
          const std::array<Ways_in_classes::Name, 2> wanted = {off + classes.key(arc),
                                                               off - classes.key(arc)};
          if(const auto name = classes.name(ways_[arc]); name != wanted[0] && name != wanted[1])
            lead_around(arc, classes, wanted, *pool.borrow());
        },
        4);
  }

  // Those of the ways in the tree that lead to them.
  std::vector<Ways_in_classes::Name> names_of_nodes(const Ways_in_classes& classes,
                                                    const std::vector<char>& is_in_tree) const {
    std::vector<Ways_in_classes::Name> names(graph_.vertex_of_node.size(), 0);
    std::vector<char> is_reached(names.size(), 0);
    for(Index root = 0; root < names.size(); ++root) {
      if(is_reached[root])
        continue;
      is_reached[root] = 1;
      std::vector<Index> reached = {root};
      for(std::size_t i = 0; i < reached.size(); ++i)
        for(const Index arc : arcs_at_[reached[i]]) {
          const auto [lower, upper] = graph_.arcs[arc];
          const Index other = lower == reached[i] ? upper : lower;
          if(is_in_tree[arc] == 0 || is_reached[other])
            continue;
          is_reached[other] = 1;
          names[other] = names[reached[i]] + classes.name(way_from(reached[i], arc));
          reached.push_back(other);
        }
    }
    return names;
  }

  void lead_around(Index arc,
                   const Ways_in_classes& classes,
                   const std::array<Ways_in_classes::Name, 2>& names,
                   Workspace& work) {
    mark(arc, work.mark);
    std::size_t size = 0; // of where it may go
    for(const Index node : graph_.arcs[arc])
      for(const Index beside : arcs_at_[node])
        size += first_ball_[beside + 1] - first_ball_[beside];
    constexpr std::size_t steps_per_ball = 4;
    const auto [lower, upper] = graph_.arcs[arc];
    const std::vector<Index> way = classes.find(
        ball_of_node_[lower], ball_of_node_[upper], names,
        [&](Index e, Index b) {
          return work.mark[b] / 2 == arc ? factor(b, arc, work) * cost(e) : -1.;
        },
        steps_per_ball * size);
    if(!way.empty())
      ways_[arc] = way;
  }

  // ---- nodes

  // A node is where parts of several arcs meet, along a contour: from the ball of its vertex it
  // goes to larger and larger ones that two of these see.
  void place_nodes() {
    for_each_index(
        execution_, ball_of_node_.size(),
        [&](std::size_t i) {
          const Index n = static_cast<Index>(i);
          ball_of_node_[n] = ball_of_vertex(graph_.vertex_of_node[n]);
          if(ball_of_node_[n] != no_index && arcs_at_[n].size() > 1)
            ball_of_node_[n] = largest_ball_from(ball_of_node_[n], balls_between(arcs_at_[n]));
        },
        16);
  }

  // Those that parts of two arcs see, sorted.
  std::vector<Index> balls_between(Span<const Index> arcs) const {
    std::vector<Index> all, between;
    for(const Index arc : arcs)
      for_each_ball(arc, [&](Index b) { all.push_back(b); });
    std::sort(all.begin(), all.end());
    for(std::size_t i = 1; i < all.size(); ++i)
      if(all[i] == all[i - 1] && (between.empty() || between.back() != all[i]))
        between.push_back(all[i]);
    return between;
  }

  Index largest_ball_from(Index ball, const std::vector<Index>& balls) const {
    for(Index before = no_index; before != ball;) {
      before = ball;
      balls_.for_each_beside(before, [&](Index other, Index) {
        if(balls_.balls[other].radius > balls_.balls[ball].radius &&
           std::binary_search(balls.begin(), balls.end(), other))
          ball = other;
      });
    }
    return ball;
  }

  std::vector<Index> way_from(Index node, Index arc) const {
    std::vector<Index> way = ways_[arc];
    if(graph_.arcs[arc][0] != node)
      std::reverse(way.begin(), way.end());
    return way;
  }

  void set_way_from(Index node, Index arc, std::vector<Index> way) {
    if(graph_.arcs[arc][0] != node)
      std::reverse(way.begin(), way.end());
    ways_[arc] = std::move(way);
  }

  using Way = std::vector<Index>;

  // How far two ways that begin at the same ball run side by side, and not as far as to their ends:
  // the numbers of the last balls on both.
  std::pair<std::size_t, std::size_t> begin_in_common(const Way& a, const Way& b) const {
    constexpr double most = 0.5; // distance between centres, in the radius
    std::size_t i = 0, j = 0;
    const auto distance = [&](std::size_t k, std::size_t l) {
      if(k + 1 >= a.size() || l + 1 >= b.size())
        return most;
      const Inner_ball &p = balls_.balls[a[k]], &q = balls_.balls[b[l]];
      return norm(q.centre - p.centre) / (std::min)(p.radius, q.radius);
    };
    for(;;) {
      const double both = distance(i + 1, j + 1), first = distance(i + 1, j),
                   second = distance(i, j + 1);
      if(!((std::min)({both, first, second}) < most))
        return {i, j};
      i += both <= second || first <= second ? 1 : 0;
      j += both <= first || second < first ? 1 : 0;
    }
  }

  // Where two of three ways begin side by side, the node goes to where they part, and the third one
  // leads there.
  void move_nodes() {
    for(Index n = 0; n < ball_of_node_.size(); ++n) {
      const Span<const Index> arcs = arcs_at_[n];
      if(arcs.size() != 3 || ball_of_node_[n] == no_index)
        continue;
      std::array<Way, 3> ways;
      for(std::size_t i = 0; i < 3; ++i) {
        ways[i] = way_from(n, arcs[i]);
        if(i > 0 && arcs[i] == arcs[i - 1]) // a cycle
          std::reverse(ways[i].begin(), ways[i].end());
      }
      if(arcs[0] == arcs[1] || arcs[1] == arcs[2])
        move_along_cycle(n, arcs[0] == arcs[1] ? 0 : 1, ways);
      else
        move_along_arcs(n, ways);
    }
  }

  void move_along_arcs(Index node, std::array<Way, 3>& ways) {
    std::pair<std::size_t, std::size_t> most = {0, 0};
    std::size_t other = 0; // than those that begin side by side
    for(std::size_t i = 0; i < 3; ++i)
      if(const auto common = begin_in_common(ways[(i + 1) % 3], ways[(i + 2) % 3]);
         common.first + common.second > most.first + most.second)
      {
        most = common;
        other = i;
      }
    Way &a = ways[(other + 1) % 3], &b = ways[(other + 2) % 3];
    if(most.first + most.second == 0 || !is_free(a[most.first], b[most.second]))
      return;
    lead_on(a, most.first, ways[other]);
    a.erase(a.begin(), a.begin() + std::ptrdiff_t(most.first));
    b.erase(b.begin(), b.begin() + std::ptrdiff_t(most.second));
    b.insert(b.begin(), a.front());
    for(std::size_t i = 0; i < 3; ++i)
      set_way_from(node, arcs_at_[node][i], ways[i]);
    ball_of_node_[node] = a.front();
  }

  // The cycle is the arc with this number and the next one.
  void move_along_cycle(Index node, std::size_t first, std::array<Way, 3>& ways) {
    Way& cycle = ways[first];
    auto [i, j] = begin_in_common(cycle, ways[first + 1]);
    if(i + j == 0 || 2 * (i + j + 2) > cycle.size() || !is_free(cycle[i], ways[first + 1][j]))
      return;
    const std::size_t other = first == 0 ? 2 : 0;
    lead_on(cycle, i, ways[other]);
    cycle.erase(cycle.end() - std::ptrdiff_t(j), cycle.end());
    cycle.erase(cycle.begin(), cycle.begin() + std::ptrdiff_t(i));
    cycle.push_back(cycle.front());
    ways_[arcs_at_[node][first]] = cycle;
    set_way_from(node, arcs_at_[node][other], ways[other]);
    ball_of_node_[node] = cycle.front();
  }

  bool is_free(Index a, Index b) const {
    return a == b || !solid_.wall().meets(balls_.balls[a].centre, balls_.balls[b].centre);
  }

  // Lets a way begin at a ball of another one, instead of where both begin.
  static void lead_on(const Way& along, std::size_t to, Way& way) {
    std::size_t from = 0; // where they part
    while(from < to && from + 1 < way.size() && along[from + 1] == way[from + 1])
      ++from;
    Way longer(along.begin() + std::ptrdiff_t(from), along.begin() + std::ptrdiff_t(to) + 1);
    std::reverse(longer.begin(), longer.end());
    longer.insert(longer.end(), way.begin() + std::ptrdiff_t(from) + 1, way.end());
    way = std::move(longer);
  }

  // Several in one ball are a little apart.
  Balls places_of_nodes() const {
    constexpr double part_of_radius = 0.05;
    std::vector<Index> nodes_in_ball(balls_.balls.size(), 0);
    for(Index b : ball_of_node_)
      if(b != no_index)
        ++nodes_in_ball[b];
    Balls places;
    for(Index n = 0; n < ball_of_node_.size(); ++n) {
      const Vector& vertex = solid_.points()[graph_.vertex_of_node[n]];
      const Index b = ball_of_node_[n];
      if(b == no_index) {
        places.push_back({vertex, 0.});
        continue;
      }
      places.push_back(balls_.balls[b]);
      const Vector off = vertex - places.back().centre;
      if(const double distance = norm(off); nodes_in_ball[b] > 1 && distance > 0.) {
        const double step = part_of_radius * places.back().radius;
        places.back().centre = places.back().centre + (step / distance) * off;
        places.back().radius -= step;
      }
    }
    return places;
  }

  // ---- drawing

  Balls line(Index arc, const Balls& nodes) const {
    const auto [lower, upper] = graph_.arcs[arc];
    Balls straight;
    if(ball_of_node_[lower] != no_index && ball_of_node_[upper] != no_index)
      for(const Index b : ways_[arc])
        straight.push_back(balls_.balls[b]);
    Balls drawn = straight;
    if(drawn.size() < 2)
      drawn = {nodes[lower], nodes[upper]};
    drawn.front() = nodes[lower];
    drawn.back() = nodes[upper];
    for(const Index node : {lower, upper}) {
      if(arcs_at_[node].size() > 1)
        leave_ball(nodes[node], drawn);
      std::reverse(drawn.begin(), drawn.end());
    }
    drawn =
        Arc_smoothing(solid_.wall(), solid_.balls(), solid_.least_extent())(drawn, false, false);
    if(!is_line_free(solid_.wall(), drawn)) {
      drawn = straight;
      drawn.insert(drawn.begin(), nodes[lower]);
      drawn.push_back(nodes[upper]);
    }
    drawn = without_repetition(drawn);
    return lower == upper && drawn.size() < 4 ? small_cycle(nodes[lower]) : drawn;
  }

  // In the ball of a node, where there is no way around elsewhere.
  static Balls small_cycle(const Inner_ball& node) {
    const double step = 0.5 * within * node.radius, radius = node.radius - step;
    const Vector& centre = node.centre;
    return {node,
            {centre + Vector{step, 0., 0.}, radius},
            {centre + Vector{0., step, 0.}, radius},
            node};
  }

  // Straight from the first place of a line to where it leaves the ball there.
  static void leave_ball(const Inner_ball& ball, Balls& line) {
    const double most = within * ball.radius;
    std::size_t i = 0;
    while(i + 1 < line.size() && norm(line[i + 1].centre - ball.centre) < most)
      ++i;
    if(i == 0)
      return;
    line.erase(line.begin() + 1, line.begin() + std::ptrdiff_t(i));
    if(line.size() == 2)
      return;
    line[1] = {exit_of_ball(ball, within, line[1].centre, line[2].centre), ball.radius - most};
  }

  // No edge but an only one is without length.
  static Balls without_repetition(const Balls& line) {
    Balls kept = {line.front()};
    for(std::size_t i = 1; i + 1 < line.size(); ++i)
      if(line[i].centre != kept.back().centre && line[i].centre != line.back().centre)
        kept.push_back(line[i]);
    kept.push_back(line.back());
    return kept;
  }

  Execution execution_;
  const Solid_balls& solid_;
  const Ball_graph& balls_;
  const Graph_of_parts& graph_;
  std::vector<char> is_connected_;  // by ball
  std::vector<Index> ball_of_node_; // `no_index`: none
  std::vector<Index> first_ball_,
      balls_of_arcs_;                    // of each arc, those of the arcs one after another
  std::vector<std::vector<Index>> ways_; // by arc
  Edges_at arcs_at_;                     // by node
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_LINES_H
