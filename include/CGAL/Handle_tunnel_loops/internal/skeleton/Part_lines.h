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

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Basis_of_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Linked_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Node_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Tree_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Arc_smoothing.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Draws a graph of parts of a surface in the middle of the solid.

A node is put into the ball that its vertex sees. The line of an arc is the cheapest way from ball
to ball, where balls that its own part of the surface sees cost less than others: these take over
where the part has no way of its own inside. Where two of the three lines at a node begin with the
same balls, the node goes to where they part. The cycles of the graph are a basis of those of the
solid. In the ball of a node lines are straight, and they are
smooth and in the middle from there on.
*/
class Part_lines
{
public:
  /// \p balls is the graph of those of the solid. All must outlive it.
  Part_lines(Execution execution,
             const Solid_balls& solid,
             const Ball_graph& balls,
             const Linked_edges& linked,
             const Graph_of_parts& graph)
      : execution_(execution)
      , solid_(solid)
      , balls_(balls)
      , linked_(linked)
      , graph_(graph)
      , drawn_(graph) {}

  Inner_drawing draw() {
    find_ways();
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

  static constexpr double within = 0.9; // of the radius of the ball of a node

  void find_ways() {
    const Part_balls part_balls(solid_, balls_, graph_);
    const Part_ways ways(balls_, part_balls, drawn_);
    Node_balls nodes(execution_, solid_.wall(), balls_, linked_, part_balls, drawn_);
    nodes.find();
    auto pool = ways.workspaces();
    for_each_index(
        execution_, drawn_.ways.size(),
        [&](std::size_t a) { drawn_.ways[a] = ways.way(static_cast<Index>(a), *pool.borrow()); },
        16);
    const Tree_of_arcs tree(part_balls, drawn_);
    Basis_of_parts(balls_, linked_, tree, drawn_).close(ways);
    nodes.move();
  }

  // Several in one ball are a little apart.
  Balls places_of_nodes() const {
    constexpr double part_of_radius = 0.05;
    std::vector<Index> nodes_in_ball(balls_.balls.size(), 0);
    for(Index b : drawn_.ball_of_node)
      if(b != no_index)
        ++nodes_in_ball[b];
    Balls places;
    for(Index n = 0; n < drawn_.ball_of_node.size(); ++n) {
      const Vector& vertex = solid_.points()[graph_.vertex_of_node[n]];
      const Index b = drawn_.ball_of_node[n];
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

  Balls line(Index arc, const Balls& nodes) const {
    const auto [lower, upper] = graph_.arcs[arc];
    Balls straight;
    if(drawn_.ball_of_node[lower] != no_index && drawn_.ball_of_node[upper] != no_index)
      for(const Index b : drawn_.ways[arc])
        straight.push_back(balls_.balls[b]);
    Balls drawn = straight;
    if(drawn.size() < 2)
      drawn = {nodes[lower], nodes[upper]};
    drawn.front() = nodes[lower];
    drawn.back() = nodes[upper];
    for(const Index node : {lower, upper}) {
      if(drawn_.arcs_at[node].size() > 1)
        leave_ball(nodes[node], drawn);
      std::reverse(drawn.begin(), drawn.end());
    }
    straight.insert(straight.begin(), nodes[lower]);
    straight.push_back(nodes[upper]);
    drawn = without_repetition(smooth(drawn, straight));
    return lower == upper && drawn.size() < 4 ? small_cycle(nodes[lower]) : drawn;
  }

  // A line that is smooth, and pulled straight if it may be: not across what the way by balls leads
  // around. This is returned if there is no such line.
  Balls smooth(const Balls& line, const Balls& way) const {
    for(const bool pulls_straight : {true, false}) {
      const Arc_smoothing smoothing(solid_.wall(), solid_.balls(), solid_.least_extent(),
                                    pulls_straight);
      if(Balls smooth = smoothing(line, false, false);
         is_line_free(solid_.wall(), smooth) && linked_.curtains().are_alike(smooth, way))
        return smooth;
    }
    return way;
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

  // No edge but an only one is without length. A line may pass its end before.
  static Balls without_repetition(const Balls& line) {
    Balls kept = {line.front()};
    for(std::size_t i = 1; i + 1 < line.size(); ++i)
      if(line[i].centre != kept.back().centre)
        kept.push_back(line[i]);
    while(kept.size() > 1 && kept.back().centre == line.back().centre)
      kept.pop_back();
    kept.push_back(line.back());
    return kept;
  }

  Execution execution_;
  const Solid_balls& solid_;
  const Ball_graph& balls_;
  const Linked_edges& linked_;
  const Graph_of_parts& graph_;
  Ways_of_arcs drawn_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_LINES_H
